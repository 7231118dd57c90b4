package org.pendant.kit.theme;

import javax.swing.JLabel;
import javax.swing.SwingConstants;
import javax.swing.plaf.basic.BasicHTML;

/**
 * Label whose text is HTML, read when the label is first in a window: most notes of panels are
 * never seen, and the first HTML of a process costs 30 ms.
 */
@SuppressWarnings("serial") // never written to a stream
public final class HtmlLabel extends JLabel {
  private static final String PLAIN = "html.disable";

  /** Without text, at the leading edge. */
  public HtmlLabel() {
    this(SwingConstants.LEADING);
  }

  /**
   * Without text.
   *
   * @param alignment of the text, horizontally; one of {@link SwingConstants}
   */
  public HtmlLabel(int alignment) {
    super("", alignment);
    putClientProperty(PLAIN, true);
  }

  @Override
  public void addNotify() {
    putClientProperty(PLAIN, null);
    BasicHTML.updateRenderer(this, getText());
    super.addNotify();
  }
}
