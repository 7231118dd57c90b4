package org.pendant.kit.layout;

import java.awt.LayoutManager;
import javax.swing.JPanel;

/** Panel with texts that wrap beside what scrolls; see {@link SettledTexts}. */
@SuppressWarnings("serial") // never written to a stream
public final class SettledPanel extends JPanel {

  /** A panel. */
  public SettledPanel(LayoutManager layout) {
    super(layout);
  }

  @Override
  protected void validateTree() {
    SettledTexts.settle(this, super::validateTree);
  }
}
