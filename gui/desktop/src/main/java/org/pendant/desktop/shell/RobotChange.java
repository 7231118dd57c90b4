package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.EventQueue;
import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.session.ProgramControls;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.background.Background;
import org.pendant.kit.settings.Settings;

/** Robot change: switches the controller off and on, perhaps with another robot. */
final class RobotChange {
  /** Name of the setting with the arm that the user has chosen last. */
  static final String ROBOT = "robot.id";

  private static final String NOISE = "robot.measured-noise";
  private static final String START_RAMP = "robot.start-ramp";
  private static final String POWER = "robot.power-at-start";

  private final RobotSession session;
  private final Consumer<CellStart> begins;
  private final Settings settings;
  private final Notices notices;
  private final Consumer<String> tell;
  private final Consumer<String> showRobot;

  /**
   * Changes of the session's robot.
   *
   * @param begins told what a cell begins with, before it does; any thread
   * @param showRobot told the id of the robot that there is
   */
  RobotChange(
      RobotSession session,
      Consumer<CellStart> begins,
      Settings settings,
      Notices notices,
      Consumer<String> tell,
      Consumer<String> showRobot) {
    this.session = session;
    this.begins = begins;
    this.settings = settings;
    this.notices = notices;
    this.tell = tell;
    this.showRobot = showRobot;
  }

  /** Whether sensors err as on recorded arms, as the user has chosen last; they do at first. */
  static boolean measuredNoise(Settings settings) {
    return settings.get(NOISE).map(Boolean::parseBoolean).orElse(true);
  }

  /** The user has chosen whether sensors err. */
  static void rememberNoise(Settings settings, boolean on) {
    settings.put(NOISE, Boolean.toString(on));
  }

  /** Whether programs have a start ramp, as the user has chosen last; they have one at first. */
  static boolean startRamp(Settings settings) {
    return settings.get(START_RAMP).map(Boolean::parseBoolean).orElse(true);
  }

  /** The user has chosen whether programs have a start ramp. */
  static void rememberStartRamp(Settings settings, boolean on) {
    settings.put(START_RAMP, Boolean.toString(on));
  }

  /**
   * Whether arms have power as soon as their controllers are switched on; they have it at first.
   */
  static boolean powerAtStart(Settings settings) {
    return settings.get(POWER).map(Boolean::parseBoolean).orElse(true);
  }

  /** Another robot; nothing happens if it is there already. */
  void choose(String id) {
    if (session.inCell()) {
      tell.accept(text("theSceneSaysWhichArmsThere"));
      showRobot.accept(session.options().robotId());
      return;
    }
    if (!id.equals(session.options().robotId())) {
      ask(text("anotherRobotEndsTheProgramThat"), text("changeRobot"), () -> change(id));
    }
  }

  /** The same robot again. */
  void restart() {
    ask(text("switchingTheControllerOffEndsThe"), text("switchOffAndOn"), this::switchOffAndOn);
  }

  /** The arm keeps its calibration and its own numbers. */
  private void switchOffAndOn() {
    Background.run(
        () -> {
          session.restartWith(each -> each.withPower(powerAtStart(settings)));
          return session.options().robotId();
        },
        done -> tell.accept(text("theControllerWasSwitchedOffAnd")),
        failed -> tell.accept(failed.getMessage()));
  }

  /** The same robot again, with sensors that err if they did not, or with exact ones. */
  void switchNoise() {
    ask(
        text("changingTheNoiseOfSensorsSwitches"),
        text("switchOffAndOn"),
        () -> setNoise(!session.options().noise().measured()));
  }

  private void setNoise(boolean on) {
    Background.run(
        () -> {
          session.changeWith(each -> each.withMeasuredNoise(on));
          return on;
        },
        done -> {
          rememberNoise(settings, on);
          tell.accept(
              on ? text("sensorsErrAsOnRecordedArms") : text("readingsOfTheSensorsAreExact"));
        },
        failed -> tell.accept(failed.getMessage()));
  }

  /** The same robot again, with the start ramp of programs if it had none, or without it. */
  void switchStartRamp() {
    ask(
        text("changingTheStartRampSwitchesThe"),
        text("switchOffAndOn"),
        () -> setStartRamp(!session.options().startRamp()));
  }

  private void setStartRamp(boolean on) {
    Background.run(
        () -> {
          session.changeWith(each -> each.withStartRamp(on));
          return on;
        },
        done -> {
          rememberStartRamp(settings, on);
          tell.accept(
              on ? text("programsBeginWithAStartRamp") : text("programsBeginWithoutAStartRamp"));
        },
        failed -> tell.accept(failed.getMessage()));
  }

  /**
   * The same robot where it stands, with other surroundings: a real one would stay on or off, too,
   * so its arm has power afterwards if it has it now.
   *
   * @param then runs when it has them
   */
  void surround(SceneFile scene, Runnable then) {
    if (!session.inCell()
        && scene.alone()
        && scene.scene().equals(session.options().scene())
        && scene.equipment().equals(session.options().equipment())) {
      then.run();
      return;
    }
    ask(
        text("anotherSceneSwitchesTheControllerOff"),
        text("changeScene"),
        () ->
            Background.run(
                () -> surround(scene),
                done -> then.run(),
                failed -> tell.accept(failed.getMessage())));
  }

  private SceneFile surround(SceneFile scene) throws IOException {
    if (scene.alone()) {
      ControllerOptions alone = session.aloneOptions();
      session.restart(
          scene.in(
              session.inCell()
                  ? alone.withPower(powerAtStart(settings))
                  : session.keepingPower(
                      session.shown().name(),
                      alone.withStart(session.state().arm().actualPositionRad()))));
      return scene;
    }
    CellStart start = CellStart.of(scene, settings);
    begins.accept(start);
    try {
      session.restart(start.setup().with(session::keepingPower));
    } catch (IllegalArgumentException e) {
      throw new IOException(e.getMessage(), e);
    }
    if (!start.troubles().isEmpty()) {
      EventQueue.invokeLater(() -> start.troubles().forEach(tell));
    }
    return scene;
  }

  private void ask(String question, String yes, Runnable change) {
    if (session.members().stream().noneMatch(each -> ProgramControls.of(each.state()).canStop())) {
      change.run();
      return;
    }
    notices.ask(
        "robot-change",
        question,
        List.of(
            new Choice("yes", yes, change),
            new Choice(
                "keep", text("keep"), () -> showRobot.accept(session.options().robotId()), true)));
    notices.focusHarmless();
  }

  private void change(String id) {
    Background.run(
        () -> {
          session.restart(session.options().withRobot(id).withPower(powerAtStart(settings)));
          return session.options().arm().displayName();
        },
        name -> {
          settings.put(ROBOT, id);
          showRobot.accept(id);
          tell.accept(text("theControllerWasSwitchedOnWith", name));
        },
        failed -> tell.accept(failed.getMessage()));
  }
}
