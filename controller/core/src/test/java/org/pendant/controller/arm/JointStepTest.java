package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;

class JointStepTest {
  private static final int N = Joints.COUNT;
  private static final double STEP_S = 0.002;

  private final JointStep step = new JointStep();

  JointStepTest() {
    for (int i = 0; i < N; i++) {
      step.massKgM2.set(i, i, 2);
      step.limitNm[i] = 100;
    }
  }

  @Test
  void jointAtRestStaysAtRestBelowItsFriction() {
    double[] speed = new double[N];
    step.coulombNm[2] = 5;
    step.freeNm[2] = 4.999;

    step.solve(STEP_S, speed);

    assertEquals(0, speed[2]);
  }

  @Test
  void jointAtRestGivesWayAboveItsFriction() {
    double[] speed = new double[N];
    step.coulombNm[2] = 5;
    step.freeNm[2] = -7;

    step.solve(STEP_S, speed);

    assertEquals(-(7 - 5) / 2.0 * STEP_S, speed[2], 1e-15);
  }

  @Test
  void frictionStopsASlowJointExactly() {
    double[] speed = {0, 1e-4, 0, 0, 0, 0};
    step.coulombNm[1] = 5;

    step.solve(STEP_S, speed);

    assertEquals(0, speed[1]);
  }

  @Test
  void stickingJointHoldsWhatItsNeighbourPullsAtIt() {
    double[] speed = new double[N];
    step.massKgM2.set(0, 1, 1);
    step.massKgM2.set(1, 0, 1);
    step.coulombNm[0] = 10;
    step.freeNm[1] = 8;

    step.solve(STEP_S, speed);

    assertEquals(0, speed[0]);
    assertEquals(8 / 2.0 * STEP_S, speed[1], 1e-15);
  }

  @Test
  void motorGivesNoMoreThanItsLimit() {
    double[] speed = new double[N];
    step.driveNm[3] = 1e6;

    step.solve(STEP_S, speed);

    assertEquals(100, step.motorNm[3]);
    assertEquals(1, step.limited[3]);
    assertEquals(100 / 2.0 * STEP_S, speed[3], 1e-15);
  }

  @Test
  void anyStiffnessIsStable() {
    double[] speed = {1, 0, 0, 0, 0, 0};
    step.slopeNmSPerRad[0] = 1e9;
    step.limitNm[0] = 1e12;

    step.solve(STEP_S, speed);

    assertTrue(speed[0] >= 0 && speed[0] < 1e-5, "speed is " + speed[0]);
  }

  @Test
  void everySolutionFulfilsTheLawsOfMotorsAndFriction() {
    Random random = new Random(7);
    for (int round = 0; round < 20_000; round++) {
      JointStep drawn = new JointStep();
      double[] before = draw(random, drawn);
      double[] after = before.clone();

      drawn.solve(STEP_S, after);

      requireLaws(drawn, before, after, "round " + round);
    }
  }

  private static double[] draw(Random random, JointStep step) {
    double[][] root = new double[N][N];
    for (double[] row : root) {
      Arrays.setAll(row, column -> random.nextGaussian());
    }
    double[] speed = new double[N];
    for (int i = 0; i < N; i++) {
      for (int j = 0; j < N; j++) {
        double sum = i == j ? 0.1 : 0;
        for (int k = 0; k < N; k++) {
          sum += root[i][k] * root[j][k];
        }
        step.massKgM2.set(i, j, sum);
      }
      step.freeNm[i] = 20 * random.nextGaussian();
      step.driveNm[i] = 200 * random.nextGaussian();
      step.slopeNmSPerRad[i] = random.nextBoolean() ? 0 : 1000 * random.nextDouble();
      step.limitNm[i] = 1 + 100 * random.nextDouble();
      step.coulombNm[i] = 10 * random.nextDouble();
      step.viscousNmSPerRad[i] = 10 * random.nextDouble();
      speed[i] = random.nextInt(3) == 0 ? 0 : random.nextGaussian();
    }
    return speed;
  }

  /** The momentum tells which torque acted; what of it was dry friction must fit the speed. */
  private static void requireLaws(JointStep step, double[] before, double[] after, String where) {
    for (int i = 0; i < N; i++) {
      double wanted = step.driveNm[i] - step.slopeNmSPerRad[i] * after[i];
      double motor = Math.max(-step.limitNm[i], Math.min(step.limitNm[i], wanted));
      assertEquals(motor, step.motorNm[i], 1e-9, where);
      double acted = 0;
      for (int j = 0; j < N; j++) {
        acted += step.massKgM2.get(i, j) * (after[j] - before[j]) / STEP_S;
      }
      double dry = motor + step.freeNm[i] - step.viscousNmSPerRad[i] * after[i] - acted;
      if (after[i] == 0) {
        assertTrue(Math.abs(dry) <= step.coulombNm[i] + 1e-6, where + ": holds with " + dry);
      } else {
        assertEquals(Math.signum(after[i]) * step.coulombNm[i], dry, 1e-6, where);
      }
    }
  }
}
