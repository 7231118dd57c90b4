package org.pendant.kit.layout;

import java.awt.Component;
import javax.swing.BorderFactory;
import javax.swing.JScrollPane;

/** Scroll pane around texts that wrap; see {@link SettledTexts}. */
@SuppressWarnings("serial") // never written to a stream
public final class SettledScroll extends JScrollPane {
  /** A scroll pane without a border, in which {@code view} scrolls. */
  public SettledScroll(Component view) {
    super(view);
    setBorder(BorderFactory.createEmptyBorder());
  }

  @Override
  protected void validateTree() {
    SettledTexts.settle(getViewport(), super::validateTree);
  }
}
