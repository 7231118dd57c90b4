package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ArmState;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.ProgramState;

/** Pauses and stops while a program steers the arm. */
final class ServoProgramTest {
  private static final double FRAME_S = 0.002;

  /** The hardest stop on a path, and what the path itself slows down meanwhile, rad/s². */
  private static final double HARDEST_RAD_PER_S2 = 16;

  /** How far the arm may be from its target when power goes and the target joins it, rad. */
  private static final double LAG_RAD = 1.2e-4;

  /** What a program does until it is stopped; each comes to more than 0.05 rad/s within 1 s. */
  enum Steering {
    LONG_SPEEDJ("  speedj([0.3, 0, 0, 0, 0, 0.1], 0.5, 60)"),
    SPEEDJ("  speedj([0.3, 0, 0, 0, 0, 0.1], 0.5, 0.002)"),
    ENDLESS_SPEEDJ("  speedj([0.3, 0, 0, 0, 0, 0.1], 0.5)"),
    SPEEDL("  speedl([0, 0.05, 0, 0, 0, 0.1], 0.3, 0.002)"),
    SERVOJ(
        """
          goal = start
          goal[0] = start[0] + 0.3 * i * get_steptime()
          i = i + 1
          servoj(goal, 0, 0, 0.002, 0.1, 300)
        """),
    SERVOC("  servoc(pose_add(get_target_tcp_pose(), p[0, 0.1, 0, 0, 0, 0]), 0.5, 0.1, 0.05)"),
    TORQUE(
        """
          speeds = get_actual_joint_speeds()
          direct_torque([0, 0, 0, 0, 0, 5 * (0.5 - speeds[5])])
        """);

    final String program;

    Steering(String body) {
      program =
          """
          def steering():
            movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])
            start = get_target_joint_positions()
            i = 0
            textmsg("begun")
            while True:
          %s
            end
          end
          """
              .formatted(body);
    }
  }

  private final RunningProgram running = new RunningProgram();
  private ArmState before;
  private double hardest;

  private ArmState arm() {
    return running.state().arm();
  }

  private void start(Steering steering) {
    running.start(steering.program);
    while (running.said().isEmpty()) {
      running.advance(1);
    }
    before = arm();
    frames(500);
    assertTrue(fastest(arm()) > 0.05, steering + " is as slow as " + fastest(arm()));
  }

  private static double fastest(ArmState arm) {
    return arm.targetSpeedRadPerS().maxAbsDifference(Joints.ZERO);
  }

  private void ask(Command command) {
    running.done(command);
    // that took a frame as well
    before = arm();
  }

  /** Continues, and looks at every frame. */
  private void frames(int count) {
    for (int i = 0; i < count; i++) {
      running.advance(1);
      ArmState now = arm();
      double change = now.targetSpeedRadPerS().maxAbsDifference(before.targetSpeedRadPerS());
      hardest = Math.max(hardest, change / FRAME_S);
      double moved = now.targetPositionRad().maxAbsDifference(before.targetPositionRad());
      assertTrue(
          moved <= (fastest(now) + fastest(before)) * FRAME_S + LAG_RAD,
          "moved by " + moved + " rad");
      before = now;
    }
  }

  private int untilRest() {
    int frames = 0;
    while (fastest(arm()) > 0) {
      frames(1);
      frames++;
      assertTrue(frames < 200, "does not come to rest");
    }
    frames(50);
    assertEquals(0, arm().actualSpeedRadPerS().maxAbsDifference(Joints.ZERO), 1e-3);
    assertEquals(0, arm().actualPositionRad().maxAbsDifference(arm().targetPositionRad()), 2e-3);
    return frames;
  }

  @ParameterizedTest
  @EnumSource
  void aPauseHoldsTheArmAndItGoesOnAfterwards(Steering steering) {
    start(steering);
    ask(new ProgramCommand.PauseProgram());
    untilRest();
    assertEquals(ProgramState.PAUSED, running.programState());
    frames(500);
    assertEquals(0, fastest(arm()));
    ask(new ProgramCommand.ResumeProgram());
    frames(500);
    assertTrue(fastest(arm()) > 0.05, "does not continue");
    assertTrue(hardest <= HARDEST_RAD_PER_S2 || steering == Steering.TORQUE, "by " + hardest);
    assertEquals(List.of(), running.reported());
  }

  @ParameterizedTest
  @EnumSource
  void aSafeguardStopHoldsTheArmAndItGoesOnAfterwards(Steering steering) {
    start(steering);
    double speed = fastest(arm());
    ask(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    int frames = untilRest();
    assertTrue(frames <= speed / 15 / FRAME_S + 4, frames + " frames from " + speed + " rad/s");
    assertEquals(SafetyMode.SAFEGUARD_STOP, running.state().safety().safetyMode());
    ask(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false));
    frames(500);
    assertEquals(ProgramState.RUNNING, running.programState());
    assertTrue(fastest(arm()) > 0.05, "does not continue");
    assertTrue(hardest <= HARDEST_RAD_PER_S2 || steering == Steering.TORQUE, "by " + hardest);
  }

  @ParameterizedTest
  @EnumSource
  void anEndedProgramLeavesTheArmAtRest(Steering steering) {
    start(steering);
    ask(new ProgramCommand.StopProgram());
    untilRest();
    assertFalse(arm().moving());
    assertTrue(hardest <= HARDEST_RAD_PER_S2 || steering == Steering.TORQUE, "by " + hardest);
    running.run("movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])");
    assertEquals(List.of(), running.reported());
  }

  @ParameterizedTest
  @EnumSource
  void anEmergencyStopLeavesTheArmAtRestWithoutPower(Steering steering) {
    start(steering);
    ask(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true));
    untilRest();
    assertEquals(RobotMode.POWER_OFF, running.state().safety().robotMode());
    assertEquals(ProgramState.STOPPED, running.programState());
    assertFalse(arm().moving());
  }

  @ParameterizedTest
  @EnumSource
  void withoutPowerTheArmIsStoppedByItsBrakes(Steering steering) {
    start(steering);
    ask(new SafetyCommand.PowerOff());
    running.advance(100);
    assertEquals(RobotMode.POWER_OFF, running.state().safety().robotMode());
    assertEquals(Joints.ZERO, arm().actualSpeedRadPerS());
    assertEquals(arm().actualPositionRad(), arm().targetPositionRad());
    assertFalse(arm().moving());
  }

  @ParameterizedTest
  @EnumSource
  void aProtectiveStopHoldsTheArm(Steering steering) {
    start(steering);
    ask(
        new ProgramCommand.RunSecondary(
            running.program("sec stop():\n  protective_stop()\nend\n")));
    untilRest();
    assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
    assertFalse(running.programState() == ProgramState.RUNNING);
  }

  @ParameterizedTest
  @EnumSource
  void atHalfSpeedItIsHalfAsFast(Steering steering) {
    ask(new BoxCommand.SetSpeedFraction(0.5));
    start(steering);
    frames(500);
    double half = fastest(arm());
    RunningProgram whole = new RunningProgram();
    whole.start(steering.program);
    while (whole.said().isEmpty()) {
      whole.advance(1);
    }
    whole.advance(1000);
    double full = fastest(whole.state().arm());
    // torques are not scaled
    double factor = steering == Steering.TORQUE ? 1 : 2;
    assertEquals(full, factor * half, 0.1 * full);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 0.99, 0.7, 0.25})
  void aStreamOfSpeedsLeadsToTheSamePlaceAtEverySliderPosition(double slider) {
    ask(new BoxCommand.SetSpeedFraction(slider));
    running.run(
        """
        begin = get_target_joint_positions()
        i = 0
        while i < 500:
          speedj([0, 0, 0, 0, 0, 0.2], 40, t=0.002)
          i = i + 1
        end
        stopj(40)
        end_of_way = get_target_joint_positions()
        textmsg(end_of_way[5] - begin[5])
        """);
    assertEquals(0.2, running.numbers().getFirst(), 0.001);
  }

  @ParameterizedTest
  @EnumSource
  void theSameProgramDoesTheSameToTheLastBit(Steering steering) {
    start(steering);
    Joints once = arm().actualPositionRad();
    ServoProgramTest again = new ServoProgramTest();
    again.start(steering);
    assertEquals(once, again.arm().actualPositionRad());
  }
}
