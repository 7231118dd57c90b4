package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.shell.Notices.Choice;

/**
 * Document saver: saves programs and the installation. What others have written to a file meanwhile
 * is replaced only by a user who was asked. Only the dispatch thread calls it; it writes elsewhere.
 */
final class DocumentSaver {
  private final SaveQueue queue;
  private final Notices notices;
  private final Consumer<String> tell;
  private final Consumer<String> warn;

  /** What came of a save. */
  private sealed interface Outcome {
    /** It is on disk. */
    record Written(SavedProgram file) implements Outcome {}

    /** Nothing was written, as the file says something else than it did. */
    record Changed(SavedProgram now) implements Outcome {}
  }

  /**
   * Saves by {@code queue}.
   *
   * @param tell tells what was done
   * @param warn tells what was not done, so that it cannot be overlooked
   */
  DocumentSaver(SaveQueue queue, Notices notices, Consumer<String> tell, Consumer<String> warn) {
    this.queue = queue;
    this.notices = notices;
    this.tell = tell;
    this.warn = warn;
  }

  /** Name of the question whether to save over what others have written. */
  static String question(ProgramDocument document) {
    return "save-over-" + System.identityHashCode(document);
  }

  /**
   * Saves a document that has a file.
   *
   * @param then hears whether it is on disk now
   */
  void save(ProgramDocument document, Consumer<Boolean> then) {
    SavedProgram file = document.toSave().orElseThrow();
    queue.add(
        file.path(),
        () -> {
          Optional<SavedProgram> known =
              document.onDisk().filter(each -> each.path().equals(file.path()));
          return () -> write(file, known);
        },
        outcome -> finished(document, outcome, then),
        failed -> failed(failed, then));
  }

  /**
   * Saves a document in a file that people have chosen.
   *
   * @param then hears whether it is on disk now
   */
  void saveAs(ProgramDocument document, SavedProgram file, Consumer<Boolean> then) {
    queue.add(
        file.path(),
        () -> () -> write(file, Optional.empty()),
        outcome -> finished(document, outcome, then),
        failed -> failed(failed, then));
  }

  /** Writes a file that is none of the open ones. */
  void export(SavedProgram file) {
    queue.add(
        file.path(),
        () -> () -> write(file, Optional.empty()),
        outcome -> tellSaved(file.path()),
        failed -> failed(failed, saved -> {}));
  }

  /**
   * Writes a file, unless it says something else on disk.
   *
   * @param known what it said when it was last read or written; empty if that does not matter
   */
  private static Outcome write(SavedProgram file, Optional<SavedProgram> known) throws IOException {
    if (known.isPresent() && Files.exists(file.path())) {
      SavedProgram now = now(file.path());
      if (!now.text().equals(known.get().text()) && !now.text().equals(file.text())) {
        return new Outcome.Changed(now);
      }
    }
    file.write();
    return new Outcome.Written(file);
  }

  private static SavedProgram now(Path path) throws IOException {
    try {
      return SavedProgram.read(path);
    } catch (IOException e) {
      throw new IOException(text("whatIsOnDiskNowCannot", e.getMessage()), e);
    }
  }

  private void finished(ProgramDocument document, Outcome outcome, Consumer<Boolean> then) {
    switch (outcome) {
      case Outcome.Written(SavedProgram file) -> {
        document.saved(file);
        notices.close(question(document));
        tellSaved(file.path());
        then.accept(true);
      }
      case Outcome.Changed(SavedProgram now) -> ask(document, now, then);
    }
  }

  private void ask(ProgramDocument document, SavedProgram now, Consumer<Boolean> then) {
    notices.close(DiskWatch.question(document));
    notices.ask(
        question(document),
        text("isNotSavedAnotherWindowOr", document.name()),
        List.of(
            new Choice(
                "read-it-again",
                text("readItAgain"),
                () -> {
                  document.reloaded(now);
                  then.accept(false);
                }),
            new Choice(
                "replace-it",
                text("replaceIt"),
                () -> {
                  document.changedOnDisk(now);
                  save(document, then);
                }),
            new Choice("cancel", text("cancel"), () -> then.accept(false), true)));
  }

  private void tellSaved(Path file) {
    tell.accept(text("saved", file.toAbsolutePath()));
  }

  private void failed(IOException trouble, Consumer<Boolean> then) {
    warn.accept(text("notSaved", trouble.getMessage()));
    then.accept(false);
  }
}
