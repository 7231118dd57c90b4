package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.theme.Palette;

/** Received script bar: says that a script came by a port, and offers to save a copy of it. */
@SuppressWarnings("serial") // never written to a stream
final class ReceivedBar extends JPanel {
  private final ProgramDocument program;

  /**
   * A bar; it goes when the program is saved.
   *
   * @param editorHost does what its button says
   */
  ReceivedBar(ProgramDocument program, EditorHost editorHost) {
    super(new MigLayout("insets 4 12 4 12, gap 8", "[grow, fill, 0::][]"));
    this.program = program;
    setName("received-bar");
    setBackground(Palette.tint(Palette.accent(), 0.10));
    setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Palette.line()));
    JLabel text = new JLabel(text("sentFromOutsideReadOnlyThe"));
    text.setName("received-text");
    text.setToolTipText(text.getText());
    add(text, "wmin 0");
    JButton save = new JButton(text("saveAsScript"));
    save.setName("received-save");
    save.addActionListener(event -> editorHost.run("file.save-as"));
    add(save);
    setVisible(program.received());
  }

  /** The program may have been saved. */
  void look() {
    setVisible(program.received());
  }
}
