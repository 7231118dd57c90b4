package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.EventQueue;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Supplier;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.workbench.Workbench;

/** Program closer: closes programs, after asking for what is not saved, and opens them again. */
final class ProgramCloser {
  private static final String SAVE = "file.save";
  private static final int MAX_KEPT = 10;

  private final Workbench workbench;
  private final Programs programs;
  private final Supplier<ProgramEditor> current;
  private final Deque<ProgramDocument> closed = new ArrayDeque<>();

  /**
   * Nothing was closed yet.
   *
   * @param current the editor in front
   */
  ProgramCloser(Workbench workbench, Programs programs, Supplier<ProgramEditor> current) {
    this.workbench = workbench;
    this.programs = programs;
    this.current = current;
  }

  /** Closes a program; asks if it has changes that are not saved. */
  void close(ProgramEditor editor) {
    ProgramDocument program = editor.program();
    if (!program.modified()) {
      closeNow(program);
      return;
    }
    programs.select(program);
    List<NoticeBar.Answer> answers = new ArrayList<>();
    if (program.file().isPresent()) {
      answers.add(
          new NoticeBar.Answer(
              "save-and-close", text("saveAndClose"), () -> saveAndClose(program)));
    } else {
      answers.add(new NoticeBar.Answer("save", text("save"), () -> workbench.actions().run(SAVE)));
    }
    answers.add(
        new NoticeBar.Answer(
            "close-without-saving", text("closeWithoutSaving"), () -> closeNow(program)));
    answers.add(
        new NoticeBar.Answer(
            "keep-open", text("keepOpen"), () -> editor.area().requestFocusInWindow()));
    editor.notice().ask(text("hasChangesNotSaved", program.name()), answers);
  }

  /**
   * The window knows how to save; the program is closed once it is on disk. Writing on means that
   * it stays.
   */
  private void saveAndClose(ProgramDocument program) {
    program.addListener(
        new ProgramDocument.Listener() {
          @Override
          public void textChanged(int offset, int removed, String added) {
            program.removeListener(this);
          }

          @Override
          public void fileChanged() {
            if (!program.modified()) {
              program.removeListener(this);
              EventQueue.invokeLater(() -> closeNow(program));
            }
          }
        });
    workbench.actions().run(SAVE);
  }

  private void closeNow(ProgramDocument program) {
    if (program.file().isPresent() || !program.text().isBlank()) {
      closed.push(program);
      if (closed.size() > MAX_KEPT) {
        closed.removeLast();
      }
    }
    programs.close(program, ProgramDocument.untitled("untitled.script", ""));
    current.get().area().requestFocusInWindow();
  }

  /** Whether there is a program to open again. */
  boolean canReopen() {
    return !closed.isEmpty();
  }

  /** Opens the program that was closed last, with the text that it had. */
  void reopen() {
    ProgramDocument program = closed.poll();
    if (program == null) {
      return;
    }
    boolean openedMeanwhile = program.file().flatMap(programs::of).isPresent();
    if (openedMeanwhile) {
      programs.select(programs.of(program.file().orElseThrow()).orElseThrow());
    } else {
      programs.select(program);
    }
    current.get().area().requestFocusInWindow();
  }
}
