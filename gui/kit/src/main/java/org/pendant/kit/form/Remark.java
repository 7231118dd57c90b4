package org.pendant.kit.form;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;

/** A sentence about a card, wrapped and never cut; gone when there is nothing to say. */
@SuppressWarnings("serial") // never written to a stream
public final class Remark extends JTextArea {
  /** How it lies in a card: as wide as that, and never a reason for the card to be wider. */
  public static final String LAYOUT = "growx, width 0:10:";

  private final Supplier<Color> color;
  private List<String> others = List.of();

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

  /**
   * Has room for each of some sentences, whichever of them it shows: what lies below does not move
   * when it says another one.
   */
  public Remark withRoomFor(List<String> sentences) {
    others = List.copyOf(sentences);
    return this;
  }

  @Override
  public Dimension getPreferredSize() {
    Dimension size = super.getPreferredSize();
    JTextArea other = new JTextArea();
    other.setFont(getFont());
    other.setBorder(getBorder());
    other.setLineWrap(true);
    other.setWrapStyleWord(true);
    for (String each : others) {
      other.setText(each);
      other.setSize(getWidth(), Short.MAX_VALUE);
      size.height = Math.max(size.height, other.getPreferredSize().height);
    }
    return size;
  }

  /** New words are no reason to scroll. */
  @Override
  public void scrollRectToVisible(Rectangle wanted) {}

  @Override
  public Color getForeground() {
    return color == null ? super.getForeground() : color.get();
  }
}
