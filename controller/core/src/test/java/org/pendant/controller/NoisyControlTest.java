package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.world.Material;
import org.pendant.models.arm.Joints;

/** What goes by sensors works with their noise as well. */
@Tag("slow")
final class NoisyControlTest {
  private static RunningProgram noisy(String robot) {
    return new RunningProgram(
        ControllerOptions.headless().withRobot(robot).withMeasuredNoise(true));
  }

  private static PressingArm pressing(String robot, double gapM) {
    return new PressingArm(
        PressingArm.tableBelow(robot, gapM, Material.DEFAULT).withMeasuredNoise(true));
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur3e", "ur5e", "ur10e", "ur20", "ur3", "ur10"})
  void noiseOfFastMovesIsNeitherACollisionNorTooFast(String robot) {
    RunningProgram running = noisy(robot);
    running.run(
        """
        i = 0
        while i < 3:
          movej([1, -1.2, -1.9, -1.2, 1.2, 1], a=15, v=3.1, r=0.05)
          movej([0, -1.57, -1.57, -1.57, 1.57, 0], a=15, v=3.1)
          movel(pose_add(get_target_tcp_pose(), p[0, 0, -0.1, 0, 0, 0]), a=3, v=1)
          movej([0, -1.57, -1.57, -1.57, 1.57, -1], a=15, v=6)
          i = i + 1
        end
        """);
    assertEquals(SafetyMode.NORMAL, running.state().safety().safetyMode());
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur5e", "ur5", "ur20"})
  void freeMotionIsNoContact(String robot) {
    RunningProgram running = noisy(robot);
    running.run(
        """
        global most = 0
        thread watch():
          while True:
            c = tool_contact()
            if c > most:
              most = c
            end
            sync()
          end
        end
        w = run watch()
        movel(pose_add(get_target_tcp_pose(), p[0, 0, -0.1, 0, 0, 0]), a=0.5, v=0.2)
        sleep(1)
        textmsg(most)
        """);
    assertEquals(List.of("0"), running.said());
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur5e", "ur5"})
  void contactIsFoundWhereTheSurfaceIs(String robot) {
    PressingArm arm = pressing(robot, 0.05);
    double table = PressingArm.tcpAtStart(robot).z() - 0.05;
    arm.start(PressingArm.TOUCH_AND_GO_BACK);
    arm.running.finish();
    assertEquals(SafetyMode.NORMAL, arm.running.state().safety().safetyMode());
    assertEquals(table, arm.target().z(), 1e-3);
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur5e", "ur10e", "ur5"})
  void forceModePressesAsItShould(String robot) {
    PressingArm arm = pressing(robot, 0.01);
    arm.start(
        """
        force_mode(p[0, 0, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, -20, 0, 0, 0], 2,\
         [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])
        sleep(10)
        """);
    arm.untilContact();
    arm.frames(750);
    double[] sum = new double[1];
    arm.frames(1000, () -> sum[0] += arm.pressN());
    assertEquals(20, sum[0] / 1000, 1);
    assertEquals(SafetyMode.NORMAL, arm.running.state().safety().safetyMode());
  }

  @Test
  void anArmThatStandsIsSteady() {
    RunningProgram running = noisy("ur5e");
    running.run(
        """
        movej([0, -1.57, -1.57, -1.57, 1.57, 0.5])
        sleep(0.6)
        textmsg(is_steady())
        """);
    assertEquals(List.of("True"), running.said());
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur5e", "ur5"})
  void aGuidedArmStaysWhereNobodyPushesIt(String robot) {
    RunningProgram running = noisy(robot);
    Joints before = running.state().arm().targetPositionRad();
    running.done(new ManualCommand.StartFreedrive(FreeAxes.ALL, FreedriveFrame.BASE));
    for (int i = 0; i < 10; i++) {
      running.advance(100);
      running.done(new ManualCommand.StartFreedrive(FreeAxes.ALL, FreedriveFrame.BASE));
    }
    Joints now = running.state().arm().actualPositionRad();
    assertTrue(now.maxAbsDifference(before) < 1e-3, now.toString());
  }

  @Test
  void theTargetOfAnArmOnItsBrakesDoesNotFollowTheNoise() {
    RunningProgram running = noisy("ur5e");
    running.ask(new SafetyCommand.PowerOff());
    running.advance(500);
    Joints target = running.state().arm().targetPositionRad();
    running.advance(500);
    assertEquals(RobotMode.POWER_OFF, running.state().safety().robotMode());
    assertEquals(target, running.state().arm().targetPositionRad());
    assertTrue(running.state().arm().steady());
  }
}
