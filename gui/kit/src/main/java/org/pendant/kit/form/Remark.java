package org.pendant.kit.form;

import java.awt.Color;
import java.awt.Rectangle;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;

/** A sentence about a card, wrapped and never cut; gone when there is nothing to say. */
@SuppressWarnings("serial") // never written to a stream
public final class Remark extends JTextArea {
  /** How it lies in a card: as wide as that, and never a reason for the card to be wider. */
  public static final String LAYOUT = "growx, width 0:10:";

  private final Supplier<Color> color;

  /**
   * Nothing to say yet.
   *
   * @param name of the component
   * @param color of the words
   */
  public Remark(String name, Supplier<Color> color) {
    this.color = color;
    setName(name);
    setEditable(false);
    setFocusable(false);
    setOpaque(false);
    setBorder(BorderFactory.createEmptyBorder());
    setLineWrap(true);
    setWrapStyleWord(true);
    setColumns(10);
    setVisible(false);
  }

  /** Shows a sentence; empty for none. */
  public void say(String text) {
    if (!getText().equals(text)) {
      setText(text);
      getAccessibleContext().setAccessibleName(text);
    }
    // with the same words too: others may have hidden it meanwhile
    setVisible(!text.isEmpty());
  }

  /** New words are no reason to scroll. */
  @Override
  public void scrollRectToVisible(Rectangle wanted) {}

  @Override
  public Color getForeground() {
    return color == null ? super.getForeground() : color.get();
  }
}
