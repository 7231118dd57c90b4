package org.pendant.kit.form;

import javax.swing.BorderFactory;
import javax.swing.JLabel;

/**
 * Document name: what a document is called, with a dot before it while it is not saved. What stands
 * behind does not move when the dot comes and goes.
 */
@SuppressWarnings("serial") // never written to a stream
public final class DocumentName extends JLabel {
  private static final String DOT = "\u2022 ";

  /**
   * No name yet.
   *
   * @param id name of the component
   */
  public DocumentName(String id) {
    setName(id);
    putClientProperty("FlatLaf.styleClass", "semibold");
  }

  /** Shows a name and whether there are changes that are not saved. */
  public void show(String name, boolean modified) {
    setText(modified ? DOT + name : name);
    int left = modified ? 0 : getFontMetrics(getFont()).stringWidth(DOT);
    setBorder(BorderFactory.createEmptyBorder(0, left, 0, 0));
  }
}
