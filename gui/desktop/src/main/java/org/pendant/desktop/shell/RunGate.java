package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.desktop.program.ProgramView;
import org.pendant.desktop.program.TreeRuns;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.shell.start.StartChoice;
import org.pendant.desktop.shell.start.StartPlace;
import org.pendant.desktop.tests.TestsView;

/**
 * Run gate: lets a program start when it can, and the arm is where it goes first or people want it
 * so.
 */
record RunGate(
    RobotSession session,
    ProgramView program,
    TreeRuns runs,
    ActiveInstallation installation,
    TestsView tests,
    StartChoice start,
    Consumer<String> tell)
    implements ProgramRunner.Gate {
  @Override
  public void pass(ProgramDocument document, long from, Runnable run) {
    if (tests.debugging()) {
      tell.accept(text("aTestIsBeingDebuggedIt"));
      return;
    }
    program.whenReady(document, () -> ask(document, from, run));
  }

  private void ask(ProgramDocument document, long from, Runnable run) {
    Optional<String> refusal = runs.whyNot(document, from);
    if (refusal.isPresent()) {
      tell.accept(text("cannotStartThere", document.name(), refusal.get()));
      return;
    }
    Optional<StartPlace> first =
        runs.first(document, from)
            .flatMap(
                place ->
                    StartPlace.of(
                        place, installation.current(), session.state().arm().description()));
    // The program may be edited while people choose.
    Runnable again =
        () ->
            program.whenReady(
                document,
                () -> {
                  if (runs.whyNot(document, from).isEmpty()) {
                    run.run();
                  }
                });
    start.begin(first, session.state(), again);
  }
}
