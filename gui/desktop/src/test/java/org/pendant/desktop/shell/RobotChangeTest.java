package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SceneFile;
import org.pendant.kit.settings.MemorySettings;

/** Whether arms are on when their controllers have been switched off and on. */
@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class RobotChangeTest {
  private static final String TABLE =
      """
      {"objects": [{"type": "plane", "name": "table", "point": [0, 0, -0.1], "normal": [0, 0, 1]}]}
      """;

  private final MemorySettings settings = new MemorySettings();
  private final RobotSession session = RobotSession.start(ControllerOptions.headless());

  @AfterEach
  void close() {
    session.close();
  }

  /** Puts a table around the arm, and says how the arm is then. */
  private RobotMode withTable() throws Exception {
    return changed(
        (change, done) -> change.surround(SceneFile.of("table.scene.json", TABLE), done));
  }

  /** What the user does in the window, which runs something when it is done. */
  private interface Doing {
    void in(RobotChange change, Runnable done) throws Exception;
  }

  private RobotMode changed(Doing doing) throws Exception {
    CompletableFuture<Boolean> done = new CompletableFuture<>();
    EventQueue.invokeAndWait(
        () -> {
          RobotChange change =
              new RobotChange(
                  session,
                  start -> {},
                  settings,
                  new Notices(),
                  text -> done.complete(true),
                  robot -> {});
          try {
            doing.in(change, () -> done.complete(true));
          } catch (Exception e) {
            done.completeExceptionally(e);
          }
        });
    done.get();
    return session.state().safety().robotMode();
  }

  private void send(SafetyCommand command) throws Exception {
    session.submit(command).get();
    // the reply comes before the frame is over that shows what came of it
    session.submit(command).get();
  }

  @Test
  void anArmThatIsOnStaysOnInAnotherScene() throws Exception {
    assertEquals(RobotMode.RUNNING, withTable());
    assertEquals(1, session.options().scene().objects().size());
  }

  @Test
  void anArmThatIsOffStaysOffInAnotherScene() throws Exception {
    send(new SafetyCommand.PowerOff());
    assertEquals(RobotMode.POWER_OFF, withTable());
  }

  @Test
  void anArmThatASafetyFunctionHasStoppedIsOffInAnotherScene() throws Exception {
    send(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    assertEquals(RobotMode.POWER_OFF, withTable());
  }

  @Test
  void anArmThatWasSwitchedOnStaysOnWhereArmsAreOffAtFirst() throws Exception {
    settings.put("robot.power-at-start", "false");
    assertEquals(RobotMode.RUNNING, withTable());
  }

  @Test
  void otherSensorsLeaveAnArmOffAndARestartIsAsAtTheStart() throws Exception {
    send(new SafetyCommand.PowerOff());
    assertEquals(RobotMode.POWER_OFF, changed((change, done) -> change.switchNoise()));
    assertEquals(RobotMode.POWER_OFF, changed((change, done) -> change.switchStartRamp()));
    assertEquals(RobotMode.RUNNING, changed((change, done) -> change.restart()));
  }
}
