package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.shell.Notices.Choice;

/**
 * Unsaved question: what shall become of changes to the only document of its kind before another
 * one takes its place.
 */
final class UnsavedQuestion {
  private final Notices notices;
  private final String kind;
  private final Supplier<ProgramDocument> document;
  private final Consumer<Consumer<Boolean>> save;

  /**
   * A question that has not been asked yet.
   *
   * @param kind what it is, such as {@code scene}
   * @param save saves it, and tells whether it is on disk then
   */
  UnsavedQuestion(
      Notices notices,
      String kind,
      Supplier<ProgramDocument> document,
      Consumer<Consumer<Boolean>> save) {
    this.notices = notices;
    this.kind = kind;
    this.document = document;
    this.save = save;
  }

  /** Runs {@code then} at once, where all is saved, or when people have said what shall become. */
  void before(Runnable then) {
    if (!document.get().modified()) {
      then.run();
      return;
    }
    Consumer<Boolean> saved =
        done -> {
          if (done) {
            then.run();
          }
        };
    notices.ask(
        kind + "-unsaved",
        text(
            kind.equals("scene") ? "theSceneIsNotSaved" : "theInstallationIsNotSaved",
            document.get().name()),
        List.of(
            new Choice("save", text("save"), () -> save.accept(saved)),
            new Choice("continue-without-saving", text("continueWithoutSaving"), then),
            Choice.nothing("cancel", text("cancel"))));
    notices.focus();
  }
}
