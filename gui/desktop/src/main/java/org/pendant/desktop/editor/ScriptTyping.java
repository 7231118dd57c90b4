package org.pendant.desktop.editor;

import java.awt.event.ActionEvent;
import java.util.AbstractList;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultEditorKit;
import javax.swing.text.Position;
import org.pendant.desktop.editor.text.AutoIndent;
import org.pendant.desktop.editor.text.BlockEnd;
import org.pendant.desktop.editor.text.BracketPairs;
import org.pendant.desktop.editor.text.TextSpan;

/**
 * Typing help: what happens besides when the user types: indentation, ends of blocks, pairs of
 * brackets.
 */
final class ScriptTyping {
  private static final int MAX_GIVEN = 20;

  private final ScriptArea area;

  /** Where the lines begin that came by themselves. */
  private final Deque<Position> given = new ArrayDeque<>();

  /** Takes over the keys of {@code area} that begin a line and delete backwards. */
  ScriptTyping(ScriptArea area) {
    this.area = area;
    area.getActionMap().put(DefaultEditorKit.insertBreakAction, new NewLine());
    area.getActionMap()
        .put(
            DefaultEditorKit.deletePrevCharAction,
            new DeleteBack(area.getActionMap().get(DefaultEditorKit.deletePrevCharAction)));
  }

  /** Writes a character, and the other half of a pair. */
  void write(char c) {
    String own = String.valueOf(c);
    int start = area.getSelectionStart();
    int end = area.getSelectionEnd();
    String selected = area.text(new TextSpan(start, end));
    if (start < end && area.tabStops().selected()) {
      area.insertPlain("");
      write(c);
      return;
    }
    if (start < end) {
      boolean around = BracketPairs.surrounds(c) && selected.indexOf('\n') < 0;
      area.insertPlain(around ? own + selected + BracketPairs.closing(c) : own);
      if (around) {
        area.setCaretPosition(start + 1);
        area.moveCaretPosition(end + 1);
      }
      return;
    }
    TextSpan line = area.line(area.lineAt(start));
    switch (BracketPairs.typed(area.text(line), start - line.start(), c)) {
      case INSERT -> area.insertPlain(own);
      case STEP_OVER -> area.setCaretPosition(start + 1);
      case INSERT_PAIR -> {
        area.insertPlain(own + BracketPairs.closing(c));
        area.setCaretPosition(start + 1);
      }
    }
    alignClosingWord();
  }

  /** A line that has just become {@code end} goes back to where its block began. */
  private void alignClosingWord() {
    int caret = area.getCaretPosition();
    TextSpan line = area.line(area.lineAt(caret));
    String content = area.text(line);
    if (caret != line.end() || content.isBlank() || !Character.isWhitespace(content.charAt(0))) {
      return;
    }
    String code = content.strip();
    if (!code.equals("end") && !code.equals("else:") && !code.equals("elif")) {
      return;
    }
    String wanted = AutoIndent.of(content, linesAbove(area.lineAt(caret))) + code;
    if (!wanted.equals(content)) {
      area.replaceRange(wanted, line.start(), line.end());
    }
  }

  private void remember(int lineStart) {
    try {
      given.addLast(area.getDocument().createPosition(lineStart));
      if (given.size() > MAX_GIVEN) {
        given.removeFirst();
      }
    } catch (BadLocationException e) {
      throw new IllegalStateException("the line has just been written", e);
    }
  }

  /** A user who writes an {@code end} over one that came by itself means the same one. */
  private void forgetEndBelow(String before, String behind) {
    int below = area.lineAt(area.getSelectionEnd()) + 1;
    if (!before.strip().equals("end") || !behind.isEmpty() || below > area.getLineCount()) {
      return;
    }
    TextSpan line = area.line(below);
    boolean ours = given.removeIf(each -> each.getOffset() == line.start());
    if (ours && area.text(line).equals(before)) {
      area.replaceRange("", line.start() - 1, line.end());
    }
  }

  /** The lines over a line; each is read when it is asked for. */
  private List<String> linesAbove(int line) {
    return new AbstractList<>() {
      @Override
      public String get(int index) {
        return area.text(area.line(index + 1));
      }

      @Override
      public int size() {
        return line - 1;
      }
    };
  }

  /** Begins a line, indented; a block that has been begun gets its end. */
  @SuppressWarnings("serial") // never written to a stream
  private final class NewLine extends AbstractAction {
    @Override
    public void actionPerformed(ActionEvent event) {
      if (!area.isEditable()) {
        return;
      }
      int start = area.getSelectionStart();
      TextSpan line = area.line(area.lineAt(start));
      String before = area.text(new TextSpan(line.start(), start));
      String behind =
          area.text(
              new TextSpan(
                  area.getSelectionEnd(), area.line(area.lineAt(area.getSelectionEnd())).end()));
      String deeper = "\n" + AutoIndent.behind(before);
      boolean endless =
          before.stripTrailing().endsWith(":")
              && behind.isBlank()
              && BlockEnd.missing(
                  index -> area.text(area.line(index + 1)),
                  area.getLineCount(),
                  area.lineAt(start) - 1);
      if (endless) {
        area.insertPlain(deeper + "\n" + AutoIndent.blanks(before) + "end");
        remember(start + deeper.length() + 1);
        area.setCaretPosition(start + deeper.length());
      } else {
        forgetEndBelow(before, behind);
        area.insertPlain(deeper);
      }
      area.tellTyped('\n');
    }
  }

  /** Deletes a character, or an empty pair of brackets. */
  @SuppressWarnings("serial") // never written to a stream
  private final class DeleteBack extends AbstractAction {
    private final Action usual;

    DeleteBack(Action usual) {
      this.usual = usual;
    }

    @Override
    public void actionPerformed(ActionEvent event) {
      int caret = area.getCaretPosition();
      TextSpan line = area.line(area.lineAt(caret));
      boolean pair =
          area.getSelectionStart() == area.getSelectionEnd()
              && BracketPairs.isEmptyPair(area.text(line), caret - line.start());
      if (pair) {
        area.replaceRange("", caret - 1, caret + 1);
      } else {
        usual.actionPerformed(event);
      }
    }
  }
}
