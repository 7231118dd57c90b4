package org.pendant.kit.layout;

import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import java.awt.Rectangle;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.Scrollable;
import javax.swing.SwingUtilities;

/**
 * Wide content: content as wide as the place that shows it, unless that is too narrow; it scrolls
 * then. The place of a scroll bar at its side is kept free, so that nothing moves when the bar
 * comes.
 */
@SuppressWarnings("serial") // never written to a stream
public final class WideContent extends JPanel implements Scrollable {
  /** Without anything in it yet. */
  public WideContent(LayoutManager layout) {
    super(layout);
  }

  @Override
  public Insets getInsets() {
    Insets insets = super.getInsets();
    if (SwingUtilities.getAncestorOfClass(JScrollPane.class, this) instanceof JScrollPane scroll
        && scroll.getViewport().getView() == this
        && !scroll.getVerticalScrollBar().isVisible()) {
      insets.right += scroll.getVerticalScrollBar().getPreferredSize().width;
    }
    return insets;
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
    return getParent().getWidth() >= getMinimumSize().width;
  }

  @Override
  public boolean getScrollableTracksViewportHeight() {
    return getParent().getHeight() >= getPreferredSize().height;
  }
}
