package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.ProgramState;

/** The start ramp of programs: time on paths rises from 0 to 1 within their first 0.160 s. */
final class StartRampProgramTest {
  private static final double FRAME_S = 0.002;
  private static final int FRAMES = 80;

  /** What the ramp takes longer: the first 80 frames are 39.5 frames of the path. */
  private static final double LATER_FRAMES = 40.5;

  private static final Joints START = new Joints(0, -1.5708, -1.5708, -1.5708, 1.5708, 0);
  private static final String MOVE = "movej([1, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=2, v=1)\n";

  /** The trapezoid of {@link #MOVE}. */
  private static final double MOVE_S = 1 / 1.0 + 1 / 2.0;

  private static RunningProgram robot(boolean ramp) {
    return new RunningProgram(ControllerOptions.headless().withStart(START).withStartRamp(ramp));
  }

  private static double baseSpeed(RunningProgram robot) {
    return robot.state().arm().targetSpeedRadPerS().get(0);
  }

  /** Frames from the first in which the base turns to the one in which it rests again. */
  private static List<Double> speeds(RunningProgram robot) {
    List<Double> speeds = new ArrayList<>();
    while (robot.programState() == ProgramState.RUNNING) {
      speeds.add(baseSpeed(robot));
      robot.advance(1);
    }
    speeds.add(baseSpeed(robot));
    return speeds;
  }

  private static int frames(RunningProgram robot, String program) {
    long before = robot.state().frame();
    robot.run(program);
    return (int) (robot.state().frame() - before);
  }

  private static int later(String program) {
    return frames(robot(true), program) - frames(robot(false), program);
  }

  @Test
  void theFirstMoveFollowsItsLawInATimeThatRisesWithTheProgram() {
    RunningProgram robot = robot(true);
    robot.start(MOVE);
    List<Double> speeds = speeds(robot);
    double tauFrames = 0;
    for (int k = 1; k <= FRAMES; k++) {
      double scale = (double) k / FRAMES;
      assertEquals(2 * tauFrames * FRAME_S * scale, speeds.get(k - 1), 1e-12, "frame " + k);
      tauFrames += scale;
    }
    assertEquals(2 * (FRAMES + 10 - LATER_FRAMES) * FRAME_S, speeds.get(FRAMES + 9), 1e-12);
  }

  /** What a UR3e published 3, 23, 43 and 63 frames after the start of its program. */
  @ParameterizedTest
  @CsvSource({
    "3, 5.89e-06, 0.002290745",
    "23, 0.003808527, 0.2411827",
    "43, 0.02541352, 0.8727737",
    "63, 0.08052884, 1.897064"
  })
  void speedsAndAccelerationsAreThoseOfARecordedArmInAllDigits(
      int frame, double speedRadPerS, double accelerationRadPerS2) {
    RunningProgram robot = robot(true);
    robot.start("movej([1, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=2.0943951, v=1.0471976)\n");
    robot.advance(frame - 1);
    assertEquals(speedRadPerS, baseSpeed(robot), 1e-6 * speedRadPerS + 1e-9);
    assertEquals(
        accelerationRadPerS2,
        robot.state().arm().targetAccelerationRadPerS2().get(0),
        1e-6 * accelerationRadPerS2);
  }

  @Test
  void accelerationIsOneAndAHalfTimesTheMovesAtTheEndOfIt() {
    RunningProgram robot = robot(true);
    robot.start(MOVE);
    double highest = 0;
    for (int i = 0; i < 200; i++) {
      highest = Math.max(highest, robot.state().arm().targetAccelerationRadPerS2().get(0));
      robot.advance(1);
    }
    assertEquals(2.94, highest, 0.005);
  }

  @Test
  void theFirstMoveTakes81MillisecondsLongerOfWhichItRestsForTwo() {
    assertEquals(Math.ceil(MOVE_S / FRAME_S), frames(robot(false), MOVE), 1);
    assertEquals(LATER_FRAMES, later(MOVE), 0.5);
  }

  @Test
  void itComesOnceAProgram() {
    String back = MOVE + "movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=2, v=1)\n";
    assertEquals(LATER_FRAMES, later(back), 0.5);
    RunningProgram robot = robot(true);
    int first = frames(robot, MOVE);
    assertEquals(first, frames(robot, back.substring(MOVE.length())));
  }

  @ParameterizedTest
  @ValueSource(strings = {"sleep(0.16)\n", "i = 0\nwhile i < 80:\n  sync()\n  i = i + 1\nend\n"})
  void aProgramThatWaitsFirstShowsNone(String wait) {
    assertEquals(0, later(wait + MOVE));
  }

  @Test
  void aProgramThatWaitsForHalfOfItShowsTheRest() {
    // the second half of the ramp is 29.75 frames of the path in 40
    assertEquals(Math.ceil(40 - 29.75), later("sleep(0.08)\n" + MOVE));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "optimovej([1, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=0.5, v=0.5)\n",
        "movel(pose_add(get_target_tcp_pose(), p[0, 0.1, 0, 0, 0, 0]))\n",
        "movep(pose_add(get_target_tcp_pose(), p[0, 0.1, 0, 0, 0, 0]))\n",
        "movej([1, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=2)\n",
      })
  void itIsOfEveryKindOfMove(String move) {
    assertEquals(LATER_FRAMES, later(move), 1);
  }

  @Test
  void speedScalingDoesNotShowIt() {
    RunningProgram robot = robot(true);
    robot.start(MOVE);
    for (int i = 0; i < FRAMES; i++) {
      assertEquals(1, robot.state().arm().speedScaling());
      robot.advance(1);
    }
  }

  @Test
  void theSpeedSliderMultipliesIt() {
    RunningProgram robot = robot(true);
    robot.done(new BoxCommand.SetSpeedFraction(0.5));
    robot.start(MOVE);
    robot.advance(FRAMES / 2 - 1);
    double tauS = 0.5 * 0.5 * (FRAMES / 2 - 1) * FRAME_S * FRAMES / 2 / FRAMES;
    assertEquals(2 * tauS * 0.5 * 0.5, baseSpeed(robot), 1e-12);
    assertEquals(0.5, robot.state().arm().speedScaling());
  }

  @Test
  void itGoesOnWhileTheProgramIsPaused() {
    RunningProgram robot = robot(true);
    robot.start(MOVE);
    robot.advance(20);
    robot.done(new ProgramCommand.PauseProgram());
    robot.advance(FRAMES);
    assertEquals(0, baseSpeed(robot));
    robot.done(new ProgramCommand.ResumeProgram());
    List<Double> speeds = speeds(robot);
    assertEquals(2 * FRAME_S, speeds.get(101) - speeds.get(100), 1e-9);
    assertEquals(1, robot.state().arm().targetPositionRad().get(0), 1e-12);
  }

  @Test
  void aStopInItIsAsShortAsEver() {
    RunningProgram robot = robot(true);
    robot.start("movej([1, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=10, v=3)\n");
    robot.advance(60);
    double speed = baseSpeed(robot);
    robot.ask(new ProgramCommand.StopProgram());
    int frames = 0;
    while (baseSpeed(robot) != 0) {
      robot.advance(1);
      frames++;
    }
    assertTrue(speed > 0.3, () -> speed + " rad/s");
    assertTrue(frames * FRAME_S < 0.2, frames + " frames");
  }

  @Test
  void secondaryProgramsDoNotBeginIt() {
    RunningProgram robot = robot(true);
    robot.start("sleep(0.2)\n" + MOVE);
    robot.advance(90);
    robot.done(new ProgramCommand.RunSecondary(robot.program("sec s():\n  textmsg(1)\nend\n")));
    List<Double> speeds = speeds(robot);
    int first = 0;
    while (speeds.get(first) == 0) {
      first++;
    }
    assertEquals(2 * FRAME_S, speeds.get(first), 1e-12);
  }

  @Test
  void speedsAndServosFollowItAsTheyFollowTheSlider() {
    RunningProgram robot = robot(true);
    robot.start("speedj([0.4, 0, 0, 0, 0, 0], 2, 1)\n");
    robot.advance(FRAMES / 2 - 1);
    double tauS = 0.5 * (FRAMES / 2 - 1) * FRAME_S * FRAMES / 2 / FRAMES;
    assertEquals(2 * tauS * 0.5, baseSpeed(robot), 1e-12);
    robot.advance(120);
    assertEquals(0.4, baseSpeed(robot), 1e-12);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 4, 10, 50})
  void programsThatFollowEachOtherInMotionHaveOneRampTogether(int everyFrames) {
    RunningProgram robot = robot(true);
    double before = 0;
    for (int i = 0; i < 300; i++) {
      if (i % everyFrames == 0) {
        robot.done(
            new ProgramCommand.ReplaceProgram(
                robot.program("speedj([0.5, 0, 0, 0, 0, 0], 2, 1)\n")));
      } else {
        robot.advance(1);
      }
      double speed = baseSpeed(robot);
      assertTrue(speed >= before - 1e-12, "frame " + i + ": " + speed + " after " + before);
      assertTrue(speed - before <= 1.6 * 2 * FRAME_S, "frame " + i);
      before = speed;
    }
    assertEquals(0.5, before, 1e-9);
  }

  @Test
  void torquesAtTheStartLeaveItOut() {
    RunningProgram robot = robot(true);
    robot.start(
        """
        i = 0
        while i < 40:
          direct_torque([20, 0, 0, 0, 0, 0])
          i = i + 1
        end
        speedj([0.5, 0, 0, 0, 0, 0], 2, 1)
        """);
    robot.advance(39);
    double speed = baseSpeed(robot);
    assertTrue(speed > 0.2, () -> speed + " rad/s");
    for (int i = 0; i < 300; i++) {
      double last = baseSpeed(robot);
      robot.advance(1);
      assertTrue(Math.abs(baseSpeed(robot) - last) < 0.1, "frame " + i);
    }
    assertEquals(0.5, baseSpeed(robot), 1e-9);
  }

  @Test
  void forceModeDoesNotFollowIt() {
    String press =
        "force_mode(p[0, 0, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, -20, 0, 0, 0], 2,"
            + " [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])\nsleep(0.3)\n";
    RunningProgram with = robot(true);
    RunningProgram without = robot(false);
    with.start(press);
    without.start(press);
    for (int i = 0; i < 100; i++) {
      assertEquals(
          without.state().arm().targetPositionRad(), with.state().arm().targetPositionRad());
      with.advance(1);
      without.advance(1);
    }
  }

  static List<String> arms() {
    return ArmLibrary.ids();
  }

  @ParameterizedTest
  @MethodSource("arms")
  void noArmIsAskedForMoreThanItCanWhenAMoveIsAsHardAsItCanBe(String arm) {
    double kg = ArmLibrary.load(arm).payloadKg();
    RunningProgram robot =
        new RunningProgram(
            ControllerOptions.headless().withRobot(arm).withStart(START).withStartRamp(true));
    robot.run(
        "set_payload("
            + kg
            + ", [0, 0, 0.05])\nmovej([1.5, -0.8, -1.2, -1, 1, 1], a=1000, v=10)\n");
    assertEquals(
        SafetyMode.NORMAL, robot.state().safety().safetyMode(), () -> robot.reported().toString());
  }
}
