package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.theme.Palette;

/** Generated script bar: says that a script comes from a program tree, and leads there. */
@SuppressWarnings("serial") // never written to a stream
final class GeneratedBar extends JPanel {

  /**
   * A bar.
   *
   * @param program the tree
   * @param editorHost does what its buttons say
   */
  GeneratedBar(ProgramDocument program, EditorHost editorHost) {
    super(new MigLayout("insets 4 12 4 12, gap 8", "[grow, fill, 0::][][]"));
    setBackground(Palette.tint(Palette.accent(), 0.10));
    setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Palette.line()));
    setName("generated-bar");
    JLabel text = new JLabel();
    text.setName("generated-text");
    say(text, program);
    program.addListener(
        new ProgramDocument.Listener() {
          @Override
          public void fileChanged() {
            say(text, program);
          }
        });
    add(text, "wmin 0");
    record Press(String name, String title, String action) {}
    for (Press each :
        List.of(
            new Press("generated-tree", text("showTheTree"), "view.program"),
            new Press("generated-save", text("saveAsScript"), "file.save-script"))) {
      JButton button = new JButton(each.title());
      button.setName(each.name());
      button.addActionListener(event -> editorHost.run(each.action()));
      add(button);
    }
  }

  private static void say(JLabel text, ProgramDocument program) {
    boolean foreign = program.readOnly();
    text.setText(
        foreign ? text("scriptOfAPolyscopeXProgram") : text("generatedFromTheProgramTree"));
    text.setToolTipText(foreign ? text.getText() : text("generatedFromTheProgramTreeWhich"));
  }
}
