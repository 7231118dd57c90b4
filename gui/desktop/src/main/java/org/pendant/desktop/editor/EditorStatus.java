package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.Problem;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.theme.Palette;

/**
 * Editor status: below the text: how many problems there are, where the caret is, how the file is
 * written.
 */
@SuppressWarnings("serial") // never written to a stream
final class EditorStatus extends JPanel {
  private static final String FORMAT_TIP = text("howTheFileIsWrittenCharacters");
  private static final String LONG_TIP = text("aTextOfMoreThanA");

  private final JButton problems = new JButton(" ");
  private final JLabel cover = new JLabel(" ");
  private final JLabel place = new JLabel(" ");
  private final JLabel format = new JLabel(" ");
  private List<Problem> counted = List.of();

  /**
   * Nothing yet.
   *
   * @param showProblems asked when the user wants to see the problems
   */
  EditorStatus(Runnable showProblems) {
    super(
        new MigLayout(
            "insets 1 8 1 12, gap 16, fillx",
            "[][grow, fill, shrinkprio 200][right][right]",
            "[center]"));
    setName("editor-status");
    setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, Palette.line()));
    cover.setForeground(Palette.quiet());
    place.setForeground(Palette.quiet());
    format.setForeground(Palette.quiet());
    problems.setName("editor-problems");
    problems.putClientProperty("JButton.buttonType", "toolBarButton");
    problems.setToolTipText(text("showsTheProblemsOfThisProgram"));
    problems.addActionListener(event -> showProblems.run());
    place.setName("editor-place");
    place.getAccessibleContext().setAccessibleName(text("placeOfTheCaret"));
    format.setName("editor-format");
    format.setToolTipText(FORMAT_TIP);
    add(problems);
    cover.setName("editor-cover");
    cover.getAccessibleContext().setAccessibleName(text("whatTestsHaveReachedOfThe"));
    add(cover, "wmin 0");
    add(place, "wmin 0");
    add(format, "wmin 0");
  }

  void show(ProgramEditor editor) {
    place.setText(place(editor.area()));
    cover.setText(editor.coverAtCaret().map(LineCover::about).orElse(" "));
    String written = format(editor.program());
    format.setText(editor.isLong() ? text("long", written) : written);
    format.setToolTipText(editor.isLong() ? LONG_TIP : FORMAT_TIP);
    List<Problem> now = editor.analysed().map(AnalysedText::problems).orElse(counted);
    if (!now.equals(counted) || problems.getText().isBlank()) {
      counted = now;
      count(now);
    }
  }

  private void count(List<Problem> now) {
    boolean errors = now.stream().anyMatch(Problem::isError);
    problems.setForeground(
        errors ? Palette.error() : now.isEmpty() ? Palette.quiet() : Palette.warning());
    String text = now.isEmpty() ? text("noProblems") : ProblemsView.summary(now);
    problems.setText(text);
    problems.getAccessibleContext().setAccessibleName(text("showsThem", text));
  }

  /** {@code Line 12, column 5}, with the length of the selection if there is one. */
  static String place(ScriptArea area) {
    int caret = area.getCaretPosition();
    int line = area.lineAt(caret);
    int selected = area.getSelectionEnd() - area.getSelectionStart();
    int column = caret - area.line(line).start() + 1;
    return text(selected > 0 ? "placeAndSelection" : "lineAndColumn", line, column, selected);
  }

  private static String format(ProgramDocument program) {
    return program
        .onDisk()
        .map(
            file ->
                (file.charset().equals(StandardCharsets.UTF_8) ? "UTF-8" : "Latin-1")
                    + (file.carriageReturns() ? ", CRLF" : ", LF"))
        .orElse(text("notOnDiskYet"));
  }
}
