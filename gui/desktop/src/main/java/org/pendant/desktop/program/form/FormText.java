package org.pendant.desktop.program.form;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;

/** Form text: wrapped sentences; never a reason for a form to be wider. */
@SuppressWarnings("serial") // never written to a stream
final class FormText extends JTextArea {
  private final transient Supplier<Color> color;
  private boolean keepsRoom;

  FormText(String name, Supplier<Color> color) {
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

  /** Keeps the room that sentences have once taken: what lies below must not jump when they go. */
  FormText keepingRoom() {
    keepsRoom = true;
    return this;
  }

  /** Gives back the room of sentences that have gone. */
  void giveRoomBack() {
    setRows(0);
    setVisible(!getText().isEmpty());
  }

  /** Shows sentences; empty for none. */
  void say(String text) {
    if (!getText().equals(text)) {
      if (keepsRoom && isVisible() && getHeight() > 0) {
        setRows(Math.max(getRows(), getHeight() / getRowHeight()));
      }
      setText(text);
      getAccessibleContext().setAccessibleName(text);
      setVisible(!text.isEmpty() || (keepsRoom && getRows() > 0));
      revalidate();
    }
  }

  /** The height that the lines need is known only with the width. */
  @Override
  public void setBounds(int x, int y, int width, int height) {
    boolean other = width != getWidth();
    super.setBounds(x, y, width, height);
    if (other) {
      EventQueue.invokeLater(this::revalidate);
    }
  }

  /** New words are no reason to scroll. */
  @Override
  public void scrollRectToVisible(Rectangle wanted) {}

  @Override
  public Color getForeground() {
    return color == null ? super.getForeground() : color.get();
  }
}
