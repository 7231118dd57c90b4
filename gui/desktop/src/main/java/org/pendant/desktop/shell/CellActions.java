package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.layout.CellLayout;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.shell.ProgramRunner.Assigned;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;

/** Cell actions: which controller of the cell is shown, and all of them at once. */
final class CellActions {
  /** Ids of the actions for all controllers. */
  static final List<String> TOGETHER = List.of("controllers.run-all", "controllers.stop-all");

  private static final String NO_CELL = text("oneControllerIsAloneAScene");

  private final RobotSession session;
  private final CellArms arms;
  private final ProgramRunner runner;
  private final Consumer<String> tell;

  private CellActions(
      RobotSession session, CellArms arms, ProgramRunner runner, Consumer<String> tell) {
    this.session = session;
    this.arms = arms;
    this.runner = runner;
    this.tell = tell;
  }

  /** Adds them. */
  static void addTo(
      ActionTable actions,
      RobotSession session,
      CellArms arms,
      ProgramRunner runner,
      Consumer<String> tell) {
    CellActions cell = new CellActions(session, arms, runner, tell);
    actions.add(
        new Action(
            TOGETHER.getFirst(),
            text("runTheProgramsOfAllControllers"),
            "control alt R",
            () -> cell.whyNoRun().isEmpty(),
            cell::runAll),
        cell::whyNoRun);
    actions.add(
        new Action(
            TOGETHER.getLast(),
            text("stopTheProgramsOfAllControllers"),
            "control alt X",
            () -> cell.whyNoStop().isEmpty(),
            cell::stopAll),
        cell::whyNoStop);
    for (int i = 1; i <= CellLayout.MAX_ARMS + 1; i++) {
      int number = i;
      actions.add(
          new Action(
              "controllers.show-" + number,
              text("showControllerOfTheCell", number),
              "control alt " + number,
              () -> cell.member(number).isPresent(),
              () -> cell.member(number).ifPresent(each -> session.show(each.name()))),
          () -> session.inCell() ? text("theCellHasFewerControllers") : NO_CELL);
    }
  }

  private Optional<SessionMember> member(int number) {
    return session.inCell()
        ? session.members().stream().skip(number - 1L).findFirst()
        : Optional.empty();
  }

  private String whyNoRun() {
    if (!session.inCell()) {
      return NO_CELL;
    }
    if (runner.loading()) {
      return runner.whyLoading();
    }
    return session.members().stream()
        .filter(each -> ProgramPhase.of(each.state()) != ProgramPhase.STOPPED)
        .map(each -> text("theProgramOfIsNotStopped", each.name()))
        .findFirst()
        .or(
            () ->
                assigned().isEmpty()
                    ? Optional.of(text("noControllerHasAProgram"))
                    : Optional.empty())
        .orElse("");
  }

  private List<Assigned> assigned() {
    List<Assigned> all = new ArrayList<>();
    for (SessionMember each : session.members()) {
      Optional<ProgramDocument> program = arms.program(each);
      program.ifPresent(document -> all.add(new Assigned(each, document)));
    }
    return all;
  }

  private void runAll() {
    List<Assigned> all = assigned();
    runner.runTogether(all);
    tell.accept(
        text(
            "running",
            String.join(
                ", ",
                all.stream()
                    .map(
                        each ->
                            text(
                                "programOnController",
                                each.document().name(),
                                each.member().name()))
                    .toList())));
  }

  private String whyNoStop() {
    if (!session.inCell()) {
      return NO_CELL;
    }
    return session.members().stream()
            .allMatch(each -> ProgramPhase.of(each.state()) == ProgramPhase.STOPPED)
        ? text("noProgramRuns")
        : "";
  }

  private void stopAll() {
    session.between(
        () ->
            session
                .members()
                .forEach(
                    each -> {
                      var _ = session.submit(each, new ProgramCommand.StopProgram());
                    }));
  }
}
