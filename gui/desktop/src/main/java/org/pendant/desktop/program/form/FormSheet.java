package org.pendant.desktop.program.form;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import net.miginfocom.swing.MigLayout;

/**
 * Form sheet: the cards of a form below each other, as wide as the window; it scrolls upwards only.
 */
@SuppressWarnings("serial") // never written to a stream
final class FormSheet extends JPanel implements Scrollable {
  FormSheet() {
    super(new MigLayout("insets 12, gap 12, wrap 1, hidemode 3", "[grow, fill, 0:400:720]"));
  }

  @Override
  public Dimension getPreferredScrollableViewportSize() {
    return getPreferredSize();
  }

  @Override
  public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
    return 2 * getFontMetrics(getFont()).getHeight();
  }

  @Override
  public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
    return visible.height;
  }

  @Override
  public boolean getScrollableTracksViewportWidth() {
    return true;
  }

  @Override
  public boolean getScrollableTracksViewportHeight() {
    return false;
  }
}
