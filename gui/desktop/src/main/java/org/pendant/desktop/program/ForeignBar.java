package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.kit.action.Actions;
import org.pendant.kit.theme.Palette;

/**
 * Foreign program bar: says above a tree that it is a program of PolyScope X, and offers copies
 * that can be changed.
 */
@SuppressWarnings("serial") // never written to a stream
final class ForeignBar extends JPanel {
  private static final String WHAT = text("programOfPolyscopeXReadOnly");

  private final JTextArea text = new JTextArea();

  /**
   * A bar, not shown yet.
   *
   * @param actions of the window, which save copies
   */
  ForeignBar(Actions actions) {
    super(new MigLayout("insets 4 12 4 12, gap 12, fillx", "[grow, fill, 0::][]"));
    setName("program-foreign-bar");
    setBackground(Palette.tint(Palette.accent(), 0.10));
    setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Palette.line()));
    text.setName("program-foreign-text");
    text.setEditable(false);
    text.setOpaque(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.getAccessibleContext().setAccessibleName(text("whatCanBeDoneWithThis"));
    add(text, "wmin 0, aligny top");
    JPanel buttons = new JPanel(new MigLayout("insets 0, gap 4, wrap", "[fill]"));
    buttons.setOpaque(false);
    record Press(String name, String title, String action) {}
    for (Press each :
        List.of(
            new Press("program", text("saveAsProgram"), "file.save-as"),
            new Press("script", text("saveAsScript"), "file.save-script"))) {
      JButton button = new JButton(each.title());
      button.setName("program-foreign-" + each.name());
      button.addActionListener(event -> actions.run(each.action()));
      buttons.add(button);
    }
    add(buttons, "aligny top");
    setVisible(false);
  }

  /** Shows what there is to say of a program, or nothing. */
  void show(ProgramDocument document) {
    setVisible(document.readOnly());
    if (document.readOnly()) {
      text.setText(
          Stream.concat(Stream.of(WHAT), remarks(document).map(ForeignBar::sentence))
              .collect(Collectors.joining("\n")));
    }
    revalidate();
  }

  private static Stream<String> remarks(ProgramDocument document) {
    return document.onDisk().stream().map(SavedProgram::remarks).flatMap(List::stream);
  }

  private static String sentence(String remark) {
    return remark.substring(0, 1).toUpperCase(Locale.ROOT) + remark.substring(1) + ".";
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (text != null) {
      text.setFont(UIManager.getFont("Label.font"));
    }
  }
}
