package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Wrench;
import org.pendant.script.vm.ProgramState;

/** How far force mode lets the arm be pushed aside where it does not give way (manual 15.12). */
final class ForceModeLimitTest {
  /** What PolyScope's own force nodes have for the axes that do not give way. */
  private static final String USUAL = "[0.1, 0.1, 0.15, 0.3490658503988659, 0.17, 0.17]";

  private PressingArm arm = new PressingArm();

  /** Gives way along z of the base, wanting nothing. */
  private static String floatZ(String limits) {
    return "force_mode(p[0, 0, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 0], 2, "
        + limits
        + ")\n";
  }

  private void push(double fx, double fy, double fz, double mz) {
    arm.running.done(new WorldCommand.PushTool(new Wrench(fx, fy, fz, 0, 0, mz)));
  }

  private SafetyMode mode() {
    return arm.running.state().safety().safetyMode();
  }

  private Optional<String> stop() {
    return arm.running.reported().stream().filter(each -> each.startsWith("C1")).findFirst();
  }

  private void keepsRunning() {
    assertEquals(SafetyMode.NORMAL, mode(), () -> arm.running.reported().toString());
    assertEquals(ProgramState.RUNNING, arm.running.programState());
  }

  @Test
  void anArmThatIsPushedFartherThanItsLimitStopsAndSaysSo() {
    arm.start(floatZ("[0.1, 0.0012, 0.1, 0.17, 0.17, 0.17]") + "sleep(10)\n");
    arm.frames(100);
    push(0, 100, 0, 0);
    arm.frames(100);
    assertEquals(SafetyMode.PROTECTIVE_STOP, mode());
    assertEquals(ProgramState.PAUSED, arm.running.programState());
    String said = stop().orElseThrow();
    assertTrue(
        said.matches(
            "C153A[0-5] protective stop at 0\\.2\\d* s: the TCP is away from its"
                + " path along y of the task frame of force mode: 0\\.001\\d* m, limit 0\\.0012 m"),
        said);
  }

  @Test
  void withAWiderLimitTheSamePushIsBorne() {
    arm.start(floatZ("[0.1, 0.003, 0.1, 0.17, 0.17, 0.17]") + "sleep(10)\n");
    arm.frames(100);
    push(0, 60, 0, 0);
    arm.frames(500);
    keepsRunning();
  }

  @Test
  void theLimitOfAnotherAxisDoesNotCount() {
    arm.start(floatZ("[0.001, 0.1, 0.1, 0.17, 0.17, 0.17]") + "sleep(10)\n");
    arm.frames(100);
    push(0, 60, 0, 0);
    arm.frames(500);
    keepsRunning();
  }

  @Test
  void aTurnHasItsLimitToo() {
    arm.start(floatZ("[0.1, 0.1, 0.1, 0.17, 0.17, 0.01]") + "sleep(10)\n");
    arm.frames(100);
    push(0, 0, 0, 20);
    arm.frames(100);
    assertEquals(SafetyMode.PROTECTIVE_STOP, mode());
    String said = stop().orElseThrow();
    assertTrue(
        said.startsWith("C153A5 ") && said.contains("is turned away from its path about z"), said);
  }

  @Test
  void withAWiderLimitTheSameTurnIsBorne() {
    arm.start(floatZ("[0.1, 0.1, 0.1, 0.17, 0.17, 0.17]") + "sleep(10)\n");
    arm.frames(100);
    push(0, 0, 0, 20);
    arm.frames(500);
    keepsRunning();
  }

  @Test
  void alongAnAxisThatGivesWayTheLimitIsASpeedOnly() {
    arm.start(floatZ("[0.1, 0.1, 0.001, 0.17, 0.17, 0.17]") + "sleep(10)\n");
    arm.frames(100);
    push(0, 0, 60, 0);
    double z = arm.target().z();
    arm.frames(500);
    keepsRunning();
    assertEquals(0.001, arm.target().z() - z, 1e-4);
  }

  @Test
  void afterForceModeThePushIsACollisionAsUsual() {
    arm.start(floatZ("[0, 0, 0.1, 0, 0, 0]") + "sleep(0.1)\nend_force_mode()\nsleep(10)\n");
    arm.frames(100);
    push(0, 60, 0, 0);
    arm.frames(100);
    assertTrue(stop().orElseThrow().startsWith("C157A4 "), () -> stop().toString());
  }

  @Test
  void aPausedProgramIsNotStopped() {
    arm.start(floatZ("[0, 0, 0.1, 0, 0, 0]") + "sleep(10)\n");
    arm.frames(100);
    arm.running.done(new ProgramCommand.PauseProgram());
    push(0, 60, 0, 0);
    arm.frames(500);
    assertEquals(SafetyMode.NORMAL, mode());
  }

  @Test
  void unlockedItGoesOnWithItsLimits() {
    arm.start(floatZ("[0.1, 0.0012, 0.1, 0.17, 0.17, 0.17]") + "sleep(100)\n");
    arm.frames(100);
    push(0, 100, 0, 0);
    arm.frames(2600);
    push(0, 0, 0, 0);
    arm.frames(500);
    arm.running.done(new SafetyCommand.UnlockProtectiveStop(false));
    arm.running.done(new ProgramCommand.ResumeProgram());
    arm.frames(500);
    keepsRunning();
    push(0, 100, 0, 0);
    arm.frames(100);
    assertEquals(SafetyMode.PROTECTIVE_STOP, mode());
  }

  @Test
  void aLoopThatAsksForForceModeInEachFrameHasTheLimitsAsWell() {
    arm.start(
        "while True:\n"
            + "force_mode(get_actual_tcp_pose(), [0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 0], 2,"
            + " [0.0012, 0.0012, 0.1, 0.17, 0.17, 0.17])\nsync()\nend\n");
    arm.frames(100);
    push(0, 100, 0, 0);
    arm.frames(100);
    assertEquals(SafetyMode.PROTECTIVE_STOP, mode());
  }

  /** A wall beside the tool, which a move along y drives into while the tool floats along z. */
  private void driveIntoWall(double limitM) {
    double y = PressingArm.tcpAtStart("ur5e").y();
    SceneObject wall =
        new SceneObject.Plane(
            "wall",
            new Vector3(0, y + 0.02, 0),
            new Vector3(0, -1, 0),
            new Material(40_000, 0.2, 0));
    arm =
        new PressingArm(
            ControllerOptions.headless()
                .withScene(new Scene(List.of(wall), Optional.empty(), List.of())));
    arm.start(
        "here = get_target_tcp_pose()\n"
            + floatZ("[0.1, " + limitM + ", 0.1, 0.17, 0.17, 0.17]")
            + "movel(pose_trans(p[0, 0.023, 0, 0, 0, 0], here), a=0.5, v=0.1)\nsleep(10)\n");
    arm.frames(700);
  }

  @Test
  void aWallInTheWayOfAMoveStopsIt() {
    driveIntoWall(0.001);
    assertEquals(SafetyMode.PROTECTIVE_STOP, mode());
    assertTrue(stop().orElseThrow().contains("along y"), () -> stop().toString());
  }

  @Test
  void withAWiderLimitTheMovePressesOnTheWall() {
    driveIntoWall(0.02);
    keepsRunning();
  }

  @ParameterizedTest
  @CsvSource({"ur5e, 0.1, 0.17", "ur3e, 0.01, 0.02", "ur10e, 0, 0", "ur5e, 0, 0"})
  void ordinaryMovesNeverComeNearALimit(String robot, double metres, double radians) {
    arm = new PressingArm(ControllerOptions.headless().withRobot(robot));
    String limits =
        "[%s, %s, 0.1, %s, %s, %s]".formatted(metres, metres, radians, radians, radians);
    arm.start(
        "home = get_target_joint_positions()\nhere = get_target_tcp_pose()\n"
            + floatZ(limits)
            + """
            movel(pose_trans(p[0, 0.15, 0, 0, 0, 0], here), a=5, v=1)
            movel(pose_trans(p[0, -0.15, 0.05, 0, 0, 0], here), a=1.2, v=0.25, r=0.02)
            movel(pose_trans(here, p[0, 0, 0, 0, 0, 0.5]), a=3, v=0.5)
            movej([0.8, -1.3, -1.7, -1.2, 1.2, 0.5], a=3, v=2)
            movej(home, a=8, v=3)
            i = 0
            while i < 400:
              speedl([0.2 * sin(i / 40), 0.2 * cos(i / 40), 0, 0, 0, 0.5 * sin(i / 30)], a=2, t=0.002)
              i = i + 1
            end
            stopl(5)
            textmsg("there")
            """);
    arm.running.finish();
    assertEquals(List.of("there"), arm.running.said(), () -> arm.running.reported().toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {USUAL, "[0.01, 0.01, 0.1, 0.05, 0.05, 0.05]"})
  void pressingOnATableIsNoDeviation(String limits) {
    arm = PressingArm.overTable(0.02);
    arm.start(
        "here = get_target_tcp_pose()\n"
            + floatZ(limits).replace("[0, 0, 0, 0, 0, 0], 2", "[0, 0, -60, 0, 0, 0], 2")
            + "sleep(1)\nmovel(pose_trans(p[0, 0.1, 0, 0, 0, 0], here), a=1, v=0.25)\nsleep(10)\n");
    arm.frames(2000);
    keepsRunning();
    assertEquals(60, arm.pressN(), 3);
  }
}
