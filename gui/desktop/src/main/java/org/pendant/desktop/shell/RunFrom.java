package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.pendant.desktop.program.TreeRuns;
import org.pendant.desktop.session.ProgramControls;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.shell.start.StartChoice;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;

/** Run-from actions: start programs that are trees. */
final class RunFrom {
  private final RobotSession session;
  private final TreeRuns runs;
  private final LongSupplier selected;
  private final ProgramRunner runner;

  private RunFrom(
      RobotSession session, TreeRuns runs, LongSupplier selected, ProgramRunner runner) {
    this.session = session;
    this.runs = runs;
    this.selected = selected;
    this.runner = runner;
  }

  /**
   * Adds them.
   *
   * @param selected key of the selected node; 0 for none
   * @param tell says what has become of a setting
   */
  static void addTo(
      ActionTable actions,
      RobotSession session,
      TreeRuns runs,
      LongSupplier selected,
      ProgramRunner runner,
      StartChoice start,
      Consumer<String> tell) {
    RunFrom from = new RunFrom(session, runs, selected, runner);
    actions.add(
        new Action(
            "program.run-from",
            text("runFromTheSelectedNode"),
            "control F5",
            () -> from.whyNot().isEmpty(),
            () -> runner.runFrom(selected.getAsLong())),
        from::whyNot);
    actions.add(
        Action.of(
                "program.ask-start",
                text("askBeforeStartingAwayFromThe"),
                "",
                () -> {
                  start.setAsks(!start.asks());
                  tell.accept(
                      start.asks()
                          ? text("programsAskWhenTheArmIs")
                          : text("programsStartWhereverTheArmIs"));
                })
            .checked(start::asks));
  }

  private String whyNot() {
    if (runner.loading()) {
      return runner.whyLoading();
    }
    ProgramControls controls = ProgramControls.of(session.state());
    if (controls.phase() != ProgramPhase.STOPPED) {
      return text("stopTheProgramFirst");
    }
    return controls.whyNoRun().isEmpty()
        ? runs.whyNot(selected.getAsLong()).orElse("")
        : controls.whyNoRun();
  }
}
