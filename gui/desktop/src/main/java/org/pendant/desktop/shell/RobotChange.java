package org.pendant.desktop.shell;

import java.util.List;
import java.util.function.Consumer;
import org.pendant.desktop.session.ProgramControls;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.background.Background;
import org.pendant.kit.settings.Settings;

/** Robot change: switches the controller off and on, perhaps with another robot. */
final class RobotChange {
  private static final String ROBOT = "robot.id";

  private final RobotSession session;
  private final Settings settings;
  private final Notices notices;
  private final Consumer<String> tell;
  private final Consumer<String> showRobot;

  /**
   * Changes of the session's robot.
   *
   * @param showRobot told the id of the robot that there is
   */
  RobotChange(
      RobotSession session,
      Settings settings,
      Notices notices,
      Consumer<String> tell,
      Consumer<String> showRobot) {
    this.session = session;
    this.settings = settings;
    this.notices = notices;
    this.tell = tell;
    this.showRobot = showRobot;
  }

  /** Another robot; nothing happens if it is there already. */
  void choose(String id) {
    if (!id.equals(session.options().robotId())) {
      ask("Another robot ends the program that runs.", "Change robot", id);
    }
  }

  /** The same robot again. */
  void restart() {
    ask(
        "Switching the controller off ends the program that runs.",
        "Switch off and on",
        session.options().robotId());
  }

  private void ask(String question, String yes, String id) {
    if (!ProgramControls.of(session.state()).canStop()) {
      change(id);
      return;
    }
    notices.ask(
        "robot-change",
        question,
        List.of(
            new Choice(yes, () -> change(id)),
            new Choice("Keep", () -> showRobot.accept(session.options().robotId()), true)));
    notices.focus();
  }

  private void change(String id) {
    Background.run(
        () -> {
          session.restart(session.options().withRobot(id));
          return id;
        },
        done -> {
          settings.put(ROBOT, id);
          showRobot.accept(id);
          tell.accept("The controller was switched on with another arm: " + id);
        },
        failed -> tell.accept(failed.getMessage()));
  }
}
