package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.Optional;
import java.util.function.Function;
import org.pendant.controller.Pace;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.desktop.session.ArmReadiness;
import org.pendant.desktop.session.ProgramControls;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.shell.chrome.PaceChoice;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;

/** Program actions: those for programs, files, the robot and its time. */
final class ProgramActions {
  private final ActionTable actions;
  private final RobotSession session;
  private final ProgramRunner runner;

  ProgramActions(ActionTable actions, RobotSession session, ProgramRunner runner) {
    this.actions = actions;
    this.session = session;
    this.runner = runner;
  }

  /** Running programs. */
  void addProgram() {
    add(
        "program.run",
        text("runOrResumeProgram"),
        "F5",
        controls -> runner.loading() ? runner.whyLoading() : controls.whyNoRun(),
        runner::runOrResume);
    add(
        "program.pause",
        text("pauseProgram"),
        "F6",
        ProgramControls::whyNoPause,
        () -> runner.send(new ProgramCommand.PauseProgram()));
    add(
        "program.stop",
        text("stopProgram"),
        "shift F5",
        controls -> runner.asking() ? "" : controls.whyNoStop(),
        runner::stop);
    add(
        "program.step",
        text("pauseInTheDebuggerOrStep"),
        "F10",
        controls -> runner.loading() ? runner.whyLoading() : controls.whyNoStep(),
        runner::step);
  }

  private void add(
      String id,
      String title,
      String keys,
      Function<ProgramControls, String> whyNot,
      Runnable run) {
    actions.add(
        new Action(id, title, keys, () -> whyNot.apply(controls()).isEmpty(), run),
        () -> whyNot.apply(controls()));
  }

  private ProgramControls controls() {
    return ProgramControls.of(session.state());
  }

  /** Power, stops and robot time. */
  void addRobot() {
    actions.add(
        new Action(
            "robot.ready",
            text("switchTheArmOnOrEnd"),
            "F4",
            () -> remedy().filter(command -> !powersOff(command)).isPresent(),
            () -> remedy().ifPresent(runner::send)),
        () ->
            remedy().filter(ProgramActions::powersOff).isPresent()
                ? text("theArmIsReady")
                : ArmReadiness.of(session.state()).hint());
    actions.add(
        new Action(
            "robot.off",
            text("switchTheArmOff"),
            "",
            () -> remedy().filter(ProgramActions::powersOff).isPresent(),
            () -> runner.send(new SafetyCommand.PowerOff())));
    actions.add(
        Action.of("clock.pause", text("pauseRobotTime"), "control F6", this::pauseTime)
            .checked(() -> session.pace() instanceof Pace.Paused));
    actions.add(
        new Action(
            "clock.step-frame",
            text("stepRobotTimeByOneFrame"),
            "control shift F6",
            () -> session.pace() instanceof Pace.Paused,
            session::stepFrame),
        () -> text("pauseRobotTimeFirst"));
    actions.add(
        Action.of(
            "clock.faster",
            text("letRobotTimeGoFaster"),
            "control alt PERIOD",
            () -> session.setPace(PaceChoice.faster(session.pace(), 1))));
    actions.add(
        Action.of(
            "clock.slower",
            text("letRobotTimeGoSlower"),
            "control alt COMMA",
            () -> session.setPace(PaceChoice.faster(session.pace(), -1))));
    actions.add(
        Action.of(
            "clock.real-time",
            text("letRobotTimeGoAsFast"),
            "",
            () -> session.setPace(Pace.REAL_TIME)));
    actions.add(
        Action.of(
                "clock.unlimited",
                text("letRobotTimeGoAsFastAsPossible"),
                "",
                () -> session.setPace(new Pace.Unlimited()))
            .foundBy(text("wordsForUnlimited")));
  }

  /** How fast programs move the arm. */
  void addSpeed() {
    addSpeed("faster", text("programs10Faster"), "control alt PAGE_UP", 10);
    addSpeed("slower", text("programs10Slower"), "control alt PAGE_DOWN", -10);
    actions.add(Action.of("speed.full", text("programsAtFullSpeed"), "", () -> sendSpeed(100)));
  }

  private void addSpeed(String id, String title, String keys, int percent) {
    actions.add(
        Action.of(
            "speed." + id,
            title,
            keys,
            () -> sendSpeed(Math.clamp(speedPercent() + percent, 0, 100))));
  }

  private int speedPercent() {
    return (int) Math.round(100 * session.state().arm().speedFraction());
  }

  private void sendSpeed(int percent) {
    runner.send(new BoxCommand.SetSpeedFraction(percent / 100.0));
  }

  private Optional<Command> remedy() {
    return ArmReadiness.of(session.state()).command();
  }

  private static boolean powersOff(Command command) {
    return command instanceof SafetyCommand.PowerOff;
  }

  private void pauseTime() {
    session.setPace(session.pace() instanceof Pace.Paused ? Pace.REAL_TIME : new Pace.Paused());
  }

  /** Files. */
  void addFiles(ProgramFiles files, Programs programs) {
    actions.add(Action.of("file.new", text("newProgram"), "control N", files::create));
    actions.add(
        Action.of("file.new-script", text("newScript"), "control alt N", files::createScript));
    actions.add(
        Action.of("file.open", text("openProgram"), "control O", files::open)
            .foundBy(text("wordsForOpening")));
    actions.add(
        new Action(
            "file.save",
            text("saveProgram"),
            "control S",
            () ->
                programs.current().modified()
                    || programs.current().file().isEmpty()
                    // it says why it cannot be saved
                    || programs.current().readOnly(),
            () -> files.save(programs.current())),
        () -> text("nothingHasChanged"));
    actions.add(
        Action.of(
            "file.save-as",
            text("saveProgramAs"),
            "control shift S",
            () -> files.saveAs(programs.current())));
    actions.add(
        new Action(
            "file.save-script",
            text("saveAsScript"),
            "",
            () -> programs.current().isTree(),
            () -> files.saveScript(programs.current())),
        () -> text("theProgramIsAScript"));
    actions.add(
        new Action(
            "file.reload",
            text("readProgramFromDiskAgain"),
            "",
            () -> programs.current().file().isPresent(),
            () -> files.reload(programs.current())),
        () -> text("theProgramWasNeverSaved"));
  }
}
