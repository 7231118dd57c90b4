package org.pendant.kit.layout;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JPanel;
import javax.swing.Scrollable;

/** Cards that scroll upwards; as wide as the window, unless that is narrower than a card. */
@SuppressWarnings("serial") // never written to a stream
public final class CardSheet extends JPanel implements Scrollable {
  /**
   * An empty sheet.
   *
   * @param gap space around and between the cards, in pixels before scaling
   * @param widestCard how wide a card becomes at most, in pixels before scaling
   */
  public CardSheet(int gap, int widestCard) {
    super(new CardColumns(gap, widestCard));
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
    return getParent().getHeight() > getPreferredSize().height;
  }
}
