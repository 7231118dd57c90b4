package org.pendant.gui.move;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import org.pendant.gui.layout.CardColumns;

/** Cards that scroll upwards; as wide as the window, unless that is narrower than a card. */
@SuppressWarnings("serial") // never written to a stream
final class CardSheet extends JPanel implements Scrollable {
  private static final int GAP = 16;
  private static final int WIDEST_CARD = 520;

  CardSheet() {
    super(new CardColumns(GAP, WIDEST_CARD));
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
    return false;
  }
}
