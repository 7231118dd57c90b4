package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.pendant.controller.sensor.ArmSensors;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Wrench;

/** The sizes of noise are those that recorded arms have. */
class SensorNoiseTest {
  private static final int FRAMES = 5000;

  private final Rig rig = noisy("ur5e");

  private static Rig noisy(String id) {
    return new Rig(ArmLibrary.load(id), Scene.EMPTY, ReadingNoise.MEASURED);
  }

  /** Standard deviation and mean of a reading while the arm holds its place. */
  private static double[] spread(Rig rig, ToDoubleFunction<SimulatedSensors> reading) {
    double sum = 0;
    double squares = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      rig.arm.step(Rig.hold(Rig.START));
      double value = reading.applyAsDouble(rig.arm.sensors());
      sum += value;
      squares += value * value;
    }
    double mean = sum / FRAMES;
    return new double[] {Math.sqrt(squares / FRAMES - mean * mean), mean};
  }

  private static void assertWithin(double least, double most, double found, String what) {
    assertTrue(
        found >= least && found <= most,
        what + " is " + found + ", must be " + least + " to " + most);
  }

  @Test
  void positionsAtRestSpreadBy15To31Microradians() {
    for (String id : List.of("ur3e", "ur5e", "ur10e", "ur20", "ur5")) {
      Rig each = noisy(id);
      for (int joint = 0; joint < Joints.COUNT; joint++) {
        int i = joint;
        // about the target: the spread itself gets lost beside the square of a position
        double target = Rig.START.get(i);
        double[] found = spread(each, sensors -> sensors.positionRad[i] - target);
        assertWithin(14.5e-6, 31e-6, found[0], id + " joint " + i);
        assertEquals(0, found[1], 2e-6, id + " joint " + i);
      }
    }
  }

  @Test
  void positionsComeInStepsOfAnEncoder() {
    rig.repeat(10, Rig.hold(Rig.START));
    for (double position : rig.arm.sensors().positionRad) {
      double steps = position / SensorNoise.POSITION_STEP_RAD;
      assertEquals(Math.rint(steps), steps, 1e-6);
    }
  }

  @Test
  void aJointThatHasNotMovedReadsNoSpeedAtAll() {
    for (int frame = 0; frame < 500; frame++) {
      rig.arm.step(Rig.hold(Rig.START));
      assertEquals(Joints.ZERO, rig.arm.speedRadPerS());
    }
    assertTrue(rig.arm.rests());
  }

  @Test
  void speedsGoToExactlyZeroInTheThirdOfASecondAfterAStop() {
    Trapezoid move = new Trapezoid(Rig.START, Rig.ELSEWHERE, 1.4, 1.05);
    for (int frame = 1; frame <= move.frames(); frame++) {
      rig.arm.step(move.at(frame));
    }
    double squares = 0;
    int quiet = 0;
    int frames = 0;
    double largest = 0;
    while (quiet < 100) {
      rig.arm.step(Rig.hold(Rig.ELSEWHERE));
      Joints speed = rig.arm.speedRadPerS();
      quiet = speed.equals(Joints.ZERO) ? quiet + 1 : 0;
      frames++;
      if (frames > 50 && frames <= 150) {
        squares += speed.squaredDistance(Joints.ZERO) / Joints.COUNT;
        largest = Math.max(largest, speed.maxAbsDifference(Joints.ZERO));
      }
    }
    assertWithin(0.0001, 0.001, Math.sqrt(squares / 100), "rms after the stop");
    assertTrue(largest < 0.003, "largest is " + largest);
    assertTrue(frames < 400, "quiet after " + frames + " frames");
  }

  @Test
  void speedsInMotionRippleAsRecorded() {
    double[] recorded = {0.0052, 0.0039, 0.0035, 0.0051, 0.012, 0.0051};
    double[] squares = new double[Joints.COUNT];
    Trapezoid move = new Trapezoid(Rig.START, Rig.ELSEWHERE, 1.4, 1.05);
    Rig exact = new Rig("ur5e");
    int frames = move.frames() - 20;
    for (int frame = 1; frame <= frames; frame++) {
      rig.arm.step(move.at(frame));
      exact.arm.step(move.at(frame));
      for (int i = 0; i < Joints.COUNT; i++) {
        double error = rig.arm.sensors().speedRadPerS[i] - exact.arm.sensors().speedRadPerS[i];
        squares[i] += error * error / frames;
      }
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      assertWithin(recorded[i] / 2, 2 * recorded[i], Math.sqrt(squares[i]), "joint " + i);
    }
  }

  @Test
  void currentsAtRestSpreadAsRecorded() {
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      int i = joint;
      double found =
          spread(rig, sensors -> sensors.currentA[i] - sensors.targetCurrentA().get(i))[0];
      if (i < 3) {
        assertWithin(0.024, 0.032, found, "joint " + i);
      } else {
        assertWithin(0.007, 0.012, found, "joint " + i);
      }
    }
  }

  @Test
  void theTorqueGoesWithTheCurrent() {
    rig.repeat(3, Rig.hold(Rig.START));
    for (int i = 0; i < Joints.COUNT; i++) {
      double constant = rig.description.actuators().get(i).torqueConstantNmPerA();
      assertEquals(rig.arm.sensors().torqueNm[i], constant * rig.arm.sensors().currentA[i], 1e-9);
    }
  }

  @Test
  void currentsInMotionAreOffByNoMoreThanTwiceOrHalfOfWhatWasRecorded() {
    assertCurrents("ur3e", new double[] {0.118, 0.124, 0.109, 0.061, 0.102, 0.137});
    assertCurrents("ur10e", new double[] {0.244, 0.330, 0.217, 0.047, 0.104, 0.126});
  }

  private static void assertCurrents(String id, double[] recorded) {
    Rig each = noisy(id);
    double[] squares = new double[Joints.COUNT];
    Trapezoid move = new Trapezoid(Rig.START, Rig.ELSEWHERE, 1.4, 1.05);
    for (int frame = 1; frame < move.frames(); frame++) {
      each.arm.step(move.at(frame));
      SimulatedSensors sensors = each.arm.sensors();
      for (int i = 0; i < Joints.COUNT; i++) {
        double error = sensors.currentA[i] - sensors.targetCurrentA().get(i);
        squares[i] += error * error / (move.frames() - 1);
      }
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      double found = Math.sqrt(squares[i]);
      assertWithin(recorded[i] / 2, 2 * recorded[i], found, id + " joint " + i);
    }
  }

  @Test
  void theForceSensorSpreadsAsRecorded() {
    assertWithin(0.09, 0.22, spread(rig, sensors -> sensors.flangeNoise6[2])[0], "force");
    assertWithin(0.003, 0.005, spread(rig, sensors -> sensors.flangeNoise6[5])[0], "torque");
    Rig old = noisy("ur5");
    assertWithin(0.3, 0.9, spread(old, sensors -> sensors.flangeNoise6[2])[0], "force of a CB3");
    assertWithin(0.12, 0.15, spread(old, sensors -> sensors.flangeNoise6[5])[0], "torque of a CB3");
  }

  @Test
  void theAccelerometerSpreadsInSteps() {
    double[] found = spread(rig, sensors -> sensors.toolAccelerationMPerS2[2] + 9.82);
    assertWithin(0.046, 0.062, found[0], "noise");
    assertEquals(0, found[1], 0.005);
    double steps =
        rig.arm.sensors().toolAccelerationMPerS2[0] / SensorNoise.ACCELERATION_STEP_M_PER_S2;
    assertEquals(Math.rint(steps), steps, 1e-9);
    double old = spread(noisy("ur5"), sensors -> sensors.toolAccelerationMPerS2[2] + 9.82)[0];
    assertWithin(0.016, 0.025, old, "noise of a CB3");
  }

  @Test
  void wristsAreWarmerThanTheBaseByAFewKelvin() {
    rig.repeat(1, Rig.hold(Rig.START));
    Joints warm = rig.arm.sensors().temperatureC();
    assertEquals(30.6, warm.q0(), 0.1);
    assertWithin(7, 9, warm.q5() - warm.q0(), "difference");
    for (int i = 0; i < Joints.COUNT; i++) {
      assertEquals(0, warm.get(i) * 16 % 1, warm.toString());
    }
  }

  @Test
  void noiseMovesNothing() {
    Rig exact = new Rig("ur5e");
    Trapezoid move = new Trapezoid(Rig.START, Rig.ELSEWHERE, 1.4, 1.05);
    double[] with = new double[12];
    double[] without = new double[12];
    for (int frame = 1; frame <= move.frames(); frame++) {
      rig.arm.step(move.at(frame));
      exact.arm.step(move.at(frame));
      rig.arm.copyFlangeInBase(with);
      exact.arm.copyFlangeInBase(without);
      assertEquals(without[9], with[9]);
    }
  }

  @Test
  void sameSeedSameReadingsToTheLastBit() {
    List<Joints> some = readings(noisy("ur5e"));
    assertEquals(some, readings(noisy("ur5e")));
    assertNotEquals(some.get(5), some.get(6));
  }

  private static List<Joints> readings(Rig rig) {
    List<Joints> readings = new ArrayList<>();
    Trapezoid move = new Trapezoid(Rig.START, Rig.ELSEWHERE, 1.4, 1.05);
    for (int frame = 1; frame <= move.frames() + 300; frame++) {
      rig.arm.step(frame <= move.frames() ? move.at(frame) : Rig.hold(Rig.ELSEWHERE));
      ArmSensors sensors = rig.arm.sensors();
      readings.addAll(List.of(sensors.positionRad(), sensors.speedRadPerS(), sensors.currentA()));
    }
    return readings;
  }

  @Test
  void anArmThatIsPushedDoesNotRest() {
    rig.repeat(400, Rig.hold(Rig.START));
    assertTrue(rig.arm.rests());
    rig.world.apply(new Wrench(0, 5, 0, 0, 0, 0));
    rig.repeat(1, Rig.hold(Rig.START));
    assertFalse(rig.arm.rests());
  }

  @Test
  void brakesHaveNoCurrent() {
    rig.repeat(5, ArmCommand.BRAKES_ON);
    assertEquals(Joints.ZERO, rig.arm.sensors().currentA());
    assertEquals(Joints.ZERO, rig.arm.sensors().externalTorqueNm());
  }
}
