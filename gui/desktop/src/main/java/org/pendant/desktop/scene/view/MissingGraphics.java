package org.pendant.desktop.scene.view;

import java.awt.BorderLayout;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.UIManager;

/**
 * Missing graphics note: stands in place of the picture where nothing can draw one; its text can be
 * copied.
 */
final class MissingGraphics extends JPanel {
  private static final long serialVersionUID = 1L;

  MissingGraphics(String reason) {
    super(new BorderLayout(0, 8));
    setBorder(BorderFactory.createEmptyBorder(16, 16, 16, 16));
    JTextArea title = text(PictureTexts.text("no3dView"));
    title.setFont(title.getFont().deriveFont(Font.BOLD));
    JTextArea note = text(PictureTexts.text("everythingElseWorksWithoutIt", reason));
    note.setName("scene-unavailable");
    note.getAccessibleContext().setAccessibleName(PictureTexts.text("whyThereIsNo3dView"));
    add(title, BorderLayout.NORTH);
    add(note, BorderLayout.CENTER);
  }

  private static JTextArea text(String words) {
    JTextArea text = new JTextArea(words);
    text.setEditable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setOpaque(false);
    text.setBorder(BorderFactory.createEmptyBorder());
    text.setFont(UIManager.getFont("Label.font"));
    return text;
  }
}
