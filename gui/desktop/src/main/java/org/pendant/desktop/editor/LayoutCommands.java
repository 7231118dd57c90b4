package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.EventQueue;
import java.util.List;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.AnalysisSchedule;
import org.pendant.desktop.editor.text.AutoIndent;
import org.pendant.desktop.editor.text.CommentToggle;
import org.pendant.desktop.editor.text.Edit;
import org.pendant.desktop.editor.text.LineMoves;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.kit.background.WorkQueue;
import org.pendant.language.service.FormatOptions;
import org.pendant.language.service.FormatResult;
import org.pendant.language.source.ByteText;

/**
 * Layout commands: what can be done with whole lines: tidy, comment, move in and out, go to one.
 */
final class LayoutCommands {
  private final ProgramEditor editor;
  private final ScriptArea area;
  private final AnalysisSchedule schedule;
  private final WorkQueue background;
  private final DocumentLink link;
  private final EditorHost editorHost;

  LayoutCommands(
      ProgramEditor editor,
      AnalysisSchedule schedule,
      WorkQueue background,
      DocumentLink link,
      EditorHost editorHost) {
    this.editor = editor;
    area = editor.area();
    this.schedule = schedule;
    this.background = background;
    this.link = link;
    this.editorHost = editorHost;
  }

  /** Lays the whole text out evenly. */
  void format() {
    schedule.whenCurrent(
        analysed ->
            background.run(
                0,
                () -> {
                  FormatResult result = analysed.analysis().format(FormatOptions.DEFAULT);
                  EventQueue.invokeLater(() -> finish(analysed, result));
                }));
  }

  private void finish(AnalysedText analysed, FormatResult result) {
    if (schedule.current().filter(now -> now == analysed).isEmpty()) {
      editorHost.tell(text("notFormattedTheTextHasChanged"));
      return;
    }
    switch (result) {
      case FormatResult.Refused refused ->
          editorHost.tell(text("notFormatted", ByteText.decoded(refused.reason())));
      case FormatResult.Formatted formatted when formatted.edits().isEmpty() ->
          editorHost.tell(text("theTextIsLaidOutAlready"));
      case FormatResult.Formatted formatted ->
          link.gather(() -> area.make(analysed.edits(formatted.edits())));
    }
  }

  /** Makes the selected lines comments, or code again. */
  void toggleComment() {
    make(CommentToggle.edits(area.getText(), area.selectedLines()));
  }

  /** Moves the selected lines one step in or out. */
  void shift(boolean deeper) {
    make(AutoIndent.shifted(area.selectedLines(), area.getText(), deeper));
  }

  /** Moves the selected lines over the one above or below. */
  void moveLines(boolean down) {
    List<TextSpan> lines = area.selectedLines();
    int first = area.lineAt(lines.getFirst().start());
    int last = first + lines.size() - 1;
    LineMoves.moved(area.getText(), lines, down)
        .ifPresent(
            move -> editor.moveLines(() -> make(move), line -> lineAfter(line, first, last, down)));
  }

  private static int lineAfter(int line, int first, int last, boolean down) {
    if (line >= first && line <= last) {
      return down ? line + 1 : line - 1;
    }
    if (line == (down ? last + 1 : first - 1)) {
      return down ? first : last;
    }
    return line;
  }

  /** Writes the selected lines once more below. */
  void duplicate() {
    make(LineMoves.duplicated(area.getText(), area.selectedLines()));
  }

  private void make(LineMoves move) {
    int caret = area.getCaret().getDot();
    int mark = area.getCaret().getMark();
    area.make(List.of(move.edit()));
    area.setCaretPosition(mark + move.shift());
    area.moveCaretPosition(caret + move.shift());
  }

  /** Takes the selected lines away. */
  void delete() {
    int column = area.getCaretPosition() - area.line(area.lineAt(area.getCaretPosition())).start();
    Edit edit = LineMoves.deleted(area.getText(), area.selectedLines());
    area.make(List.of(edit));
    TextSpan line =
        area.line(area.lineAt(Math.min(edit.span().start(), area.getDocument().getLength())));
    area.setCaretPosition(Math.min(line.start() + column, line.end()));
  }

  private void make(List<Edit> edits) {
    if (edits.isEmpty()) {
      return;
    }
    int from = Edit.moved(area.getSelectionStart(), edits);
    int to = Edit.moved(area.getSelectionEnd(), edits);
    boolean selected = area.getSelectionStart() < area.getSelectionEnd();
    area.make(edits);
    if (selected) {
      area.setCaretPosition(from);
      area.moveCaretPosition(to);
    }
  }

  /** Asks for a line and goes there. */
  void goToLine() {
    int lines = area.getLineCount();
    String question = text("goToLine1To", lines);
    int now = area.lineAt(area.getCaretPosition());
    InlinePrompt.ask(
        area,
        area.place(area.getCaretPosition()),
        question,
        Integer.toString(now),
        prompt -> goTo(prompt, lines));
  }

  private void goTo(InlinePrompt prompt, int lines) {
    String text = prompt.text();
    boolean number = text.matches("\\d{1,9}");
    if (!number || Integer.parseInt(text) < 1 || Integer.parseInt(text) > lines) {
      prompt.refuse(text("lineIsMustBe1To", text, lines));
      return;
    }
    prompt.close();
    editorHost.leaving(editor);
    int start = area.line(Integer.parseInt(text)).start();
    area.show(new TextSpan(start, start));
  }
}
