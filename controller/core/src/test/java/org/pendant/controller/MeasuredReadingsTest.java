package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** What a controller says and does whose sensors have the noise of recorded ones. */
class MeasuredReadingsTest {
  private static ControllerOptions measured(String robot) {
    return ControllerOptions.headless().withRobot(robot).withMeasuredNoise(true);
  }

  private static void assertWithin(double least, double most, double found, String what) {
    assertTrue(
        found >= least && found <= most,
        what + " is " + found + ", must be " + least + " to " + most);
  }

  /** Mean and standard deviation over the frames to come. */
  private static double[] meanAndSpread(
      RunningProgram robot, int frames, ToDoubleFunction<ControllerState> reading) {
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < frames; i++) {
      robot.advance(1);
      double value = reading.applyAsDouble(robot.state());
      sum += value;
      squares += value * value;
    }
    double mean = sum / frames;
    return new double[] {mean, Math.sqrt(Math.max(0, squares / frames - mean * mean))};
  }

  @Test
  void voltagesAreThoseOfRecordedBoxes() {
    RunningProgram robot = new RunningProgram(measured("ur5e"));
    double[] box = meanAndSpread(robot, 2000, s -> s.readings().voltages().boxV());
    assertWithin(47.66, 47.84, box[0], "box");
    assertWithin(0.017, 0.019, box[1], "noise of the box");
    double[] arm = meanAndSpread(robot, 2000, s -> s.readings().voltages().robotV());
    assertWithin(47.5, 47.95, arm[0], "arm");
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      int i = joint;
      double[] each = meanAndSpread(robot, 2000, s -> s.readings().voltages().jointV().get(i));
      assertWithin(47.2, 47.95, each[0], "joint " + i);
      assertWithin(0.012, 0.027, each[1], "noise of joint " + i);
    }
    double old =
        meanAndSpread(
            new RunningProgram(measured("ur5")), 100, s -> s.readings().voltages().boxV())[0];
    assertEquals(48.2, old, 0.1);
  }

  @Test
  void theCurrentOfTheArmIsThatOfRecordedOnes() {
    double[] found =
        meanAndSpread(
            new RunningProgram(measured("ur5e")), 2000, s -> s.readings().robotCurrentA());
    assertWithin(0.52, 0.74, found[0], "current");
    assertWithin(0.035, 0.06, found[1], "noise");
  }

  @Test
  void aFrameTakesAsLongAsOnARecordedBox() {
    RunningProgram robot = new RunningProgram(measured("ur5e"));
    assertEquals(0.43e-3, meanAndSpread(robot, 1000, ControllerState::executionTimeS)[0], 0.01e-3);
    robot.start("sleep(10)\n");
    robot.advance(2);
    assertEquals(0.82e-3, meanAndSpread(robot, 1000, ControllerState::executionTimeS)[0], 0.02e-3);
  }

  @Test
  void aRobotThatDoesNothingHasNoMomentumAndNoSpeed() {
    RunningProgram robot = new RunningProgram(measured("ur5e"));
    for (int i = 0; i < 500; i++) {
      robot.advance(1);
      assertEquals(0, robot.state().readings().momentumKgMPerS());
      assertEquals(Pose.ZERO, robot.state().geometry().actual().speed());
    }
    assertTrue(robot.state().armRests());
  }

  @Test
  void noiseLeavesRandomNumbersAlone() {
    String program = "textmsg(random())\ntextmsg(random())\n";
    RunningProgram exact = new RunningProgram(ControllerOptions.headless().withSeed(7));
    RunningProgram noisy = new RunningProgram(measured("ur5e").withSeed(7));
    exact.run(program);
    noisy.run(program);
    assertEquals(exact.said(), noisy.said());
  }

  @Test
  void seedsMakeOtherReadings() {
    RunningProgram one = new RunningProgram(measured("ur5e").withSeed(1));
    RunningProgram other = new RunningProgram(measured("ur5e").withSeed(2));
    one.advance(5);
    other.advance(5);
    assertNotEquals(one.state().arm().actualPositionRad(), other.state().arm().actualPositionRad());
  }

  @Test
  void anIdealArmHasExactReadings() {
    RunningProgram robot = new RunningProgram(measured("ur5e").withArm(ArmChoice.IDEAL));
    robot.advance(5);
    assertEquals(robot.state().arm().targetPositionRad(), robot.state().arm().actualPositionRad());
    assertEquals(48, robot.state().readings().voltages().boxV());
  }
}
