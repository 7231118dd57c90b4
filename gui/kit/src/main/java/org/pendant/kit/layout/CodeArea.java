package org.pendant.kit.layout;

import java.awt.Font;
import javax.swing.JTextArea;
import javax.swing.UIManager;

/** A text in which all letters are as wide, under every look. */
@SuppressWarnings("serial") // never written to a stream
public final class CodeArea extends JTextArea {
  @Override
  public void updateUI() {
    super.updateUI();
    Font font = UIManager.getFont("monospaced.font");
    if (font != null) {
      // not the look's own object, in whose place it would put that of text areas
      setFont(font.deriveFont(font.getSize2D()));
    }
  }
}
