package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.tests.TestsView;
import org.pendant.desktop.testwriter.OperatedRun;
import org.pendant.desktop.testwriter.RunReader;
import org.pendant.desktop.testwriter.RunWords;
import org.pendant.desktop.testwriter.TestFileName;
import org.pendant.desktop.testwriter.TestScript;
import org.pendant.kit.action.Action;
import org.pendant.kit.background.Background;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.language.source.ByteText;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.Recording;
import org.pendant.recording.replay.Journal;

/** Run as test: saves the last run of the timeline as a test of its program. */
final class RunAsTest {
  private static final String NOTHING = text("noProgramHasRunYet");

  private final ShellWorkbench workbench;
  private final Programs programs;
  private final PastViews past;
  private final TestsView tests;
  private final UnaryOperator<String> names;

  /** What can be written, and where it is suggested to be. */
  private record Draft(
      ProgramDocument program, Path programFile, OperatedRun facts, Path suggestion) {}

  private RunAsTest(
      ShellWorkbench workbench,
      Programs programs,
      PastViews past,
      TestsView tests,
      UnaryOperator<String> names) {
    this.workbench = workbench;
    this.programs = programs;
    this.past = past;
    this.tests = tests;
    this.names = names;
  }

  /**
   * Adds the action, and its buttons on timeline and tests.
   *
   * @param names the names of signals such as {@code digital_in[0]}; empty for none
   */
  static void addTo(
      ShellWorkbench workbench,
      Programs programs,
      PastViews past,
      TestsView tests,
      UnaryOperator<String> names) {
    RunAsTest all = new RunAsTest(workbench, programs, past, tests, names);
    workbench
        .actions()
        .add(
            new Action(
                TestsView.ID + ".save-run",
                text("testsSaveTheLastRunAs"),
                "control alt S",
                () -> all.whyNot().isEmpty(),
                all::save),
            all::whyNot);
    past.timeline().saveTestBy(all::whyNot, all::save);
    tests.writeTestBy(all::whyNot, all::save);
  }

  private static Optional<RecordedProgram> last(Recording recording) {
    List<RecordedProgram> ran = recording.programs();
    return ran.isEmpty() ? Optional.empty() : Optional.of(ran.getLast());
  }

  /** The open program that ran. */
  private Optional<ProgramDocument> open(RecordedProgram ran) {
    String name = ran.source().name();
    return programs.all().stream()
        .filter(each -> sameName(each.script().sourceName(), name))
        .findFirst();
  }

  private static boolean sameName(String open, String recorded) {
    return open.equals(recorded) || open.equals(ByteText.decoded(recorded));
  }

  private String whyNot() {
    if (tests.debugging()) {
      return text("aTestIsBeingDebugged");
    }
    Optional<RecordedProgram> ran = last(past.recording());
    if (ran.isEmpty()) {
      return NOTHING;
    }
    Optional<ProgramDocument> program = open(ran.get());
    if (program.isEmpty()) {
      return text("theLastRunIsOfWhich", ByteText.decoded(ran.get().name()));
    }
    return program.get().file().isEmpty() ? text("hasNoFileThatATest", program.get().name()) : "";
  }

  private void save() {
    String why = whyNot();
    if (!why.isEmpty()) {
      workbench.notify(why);
      return;
    }
    Recording recording = past.recording();
    RecordedProgram ran = last(recording).orElseThrow();
    ProgramDocument program = open(ran).orElseThrow();
    Path file = program.file().orElseThrow();
    boolean edited = !program.script().source().text().equals(ran.source().text());
    boolean live = !past.ofFile();
    Background.run(
        () -> {
          Optional<List<Journal.Noted>> noted =
              live ? Optional.of(workbench.session().commandsAfter(0)) : Optional.empty();
          OperatedRun facts = read(recording, noted);
          return new Draft(
              program,
              file,
              edited ? facts.withLeft(text("wasEditedOrRunFromA", program.name())) : facts,
              TestFileName.free(file.toAbsolutePath(), Files::exists));
        },
        this::ask,
        failed -> workbench.notify(text("noTestWasWritten", failed.getMessage())));
  }

  private static OperatedRun read(Recording recording, Optional<List<Journal.Noted>> noted)
      throws IOException {
    try {
      return RunReader.read(recording, noted)
          .orElseThrow(() -> new IOException(text("theStartOfTheLastRun")));
    } catch (UncheckedIOException e) {
      throw new IOException(FileTrouble.reason(e.getCause()), e);
    }
  }

  private void ask(Draft draft) {
    SaveDialog.ask(
        past.timeline().component().isShowing() ? past.timeline().component() : tests.component(),
        new SaveRequest(
            text("saveTheLastRunAsA"),
            draft.suggestion(),
            List.of("script"),
            TestFileName::named,
            workbench.openFiles()),
        chosen -> chosen.ifPresent(test -> write(draft, test)));
  }

  private void write(Draft draft, Path test) {
    Optional<String> program = TestFileName.program(draft.programFile(), test);
    if (program.isEmpty()) {
      workbench.notify(text("notSavedATestMustBe"));
      return;
    }
    String word = TestFileName.word(test);
    String text = TestScript.of(draft.facts(), word, program.get(), names);
    Background.run(
        () -> {
          AtomicFile.write(test, text.getBytes(StandardCharsets.UTF_8));
          return test;
        },
        written -> {
          workbench.notify(RunWords.saved(written, draft.facts()));
          if (programs.all().contains(draft.program())) {
            programs.select(draft.program());
          }
          tests.showNew(written, TestScript.function(word));
        },
        failed -> workbench.notify(text("notSaved", failed.getMessage())));
  }
}
