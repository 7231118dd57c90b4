package org.pendant.kit.layout;

import java.awt.Component;
import javax.swing.JScrollPane;

/** Scroll pane around texts that wrap; see {@link SettledTexts}. */
@SuppressWarnings("serial") // never written to a stream
public final class SettledScroll extends JScrollPane {
  /**
   * A scroll pane.
   *
   * @param view what scrolls in it
   */
  public SettledScroll(Component view) {
    super(view);
  }

  /**
   * A scroll pane.
   *
   * @param view what scrolls in it
   * @param vertical as {@link JScrollPane#setVerticalScrollBarPolicy} has it
   * @param horizontal as {@link JScrollPane#setHorizontalScrollBarPolicy} has it
   */
  public SettledScroll(Component view, int vertical, int horizontal) {
    super(view, vertical, horizontal);
  }

  @Override
  protected void validateTree() {
    SettledTexts.settle(getViewport(), super::validateTree);
  }
}
