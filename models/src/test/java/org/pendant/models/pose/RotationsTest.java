package org.pendant.models.pose;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;

class RotationsTest {
  private static final int CASES = 1000;

  /** Angles at which formulas change or lose digits. */
  private static final double[] ANGLES = {
    0,
    1e-300,
    1e-160,
    1e-20,
    1e-12,
    1e-9,
    9.9e-5,
    1.01e-4,
    0.1,
    1,
    Math.PI / 2,
    2,
    3,
    Math.PI - 1e-4,
    Math.PI - 1e-9,
    Math.PI - 1e-11
  };

  private static final double[] AROUND_HALF_A_TURN = {
    0,
    1e-9,
    1,
    Math.PI - 1e-6,
    Math.PI - 1e-9,
    Math.PI - 3e-12,
    Math.PI - 1e-12,
    Math.PI,
    Math.PI + 1e-12,
    Math.PI + 3e-12,
    Math.PI + 1e-9,
    5,
    2 * Math.PI
  };

  @Test
  void rotationVectorToRpyGivesTheManualsExample() {
    double[] rpy = new double[3];
    Rotations.vectorToRpy(3.14, 1.57, 0, rpy);
    assertArrayEquals(new double[] {-2.80856, -0.16202, 0.9}, rpy, 6e-6);
  }

  @Test
  void rpyToRotationVectorGivesTheManualsExample() {
    double[] vector = new double[3];
    Rotations.rpyToVector(3.14, 1.57, 0, vector);
    assertArrayEquals(new double[] {2.22153, 0.00177, -2.21976}, vector, 6e-6);
  }

  @Test
  void vectorSurvivesTheWayThroughMatrixAndQuaternion() {
    Random random = new Random(21);
    for (double angle : ANGLES) {
      for (int n = 0; n < CASES; n++) {
        double[] axis = Samples.axis(random);
        double[] vector = {angle * axis[0], angle * axis[1], angle * axis[2]};
        // near half a turn the axis keeps 1e-16 and the angle some 1e-16 of pi
        double tolerance = angle < 1e-8 ? 1e-15 * angle + 1e-31 : 2e-15;
        String input = angle + " about " + axis[0] + ", " + axis[1] + ", " + axis[2];
        double[] quaternion = new double[4];
        double[] result = new double[3];
        Rotations.vectorToQuaternion(vector[0], vector[1], vector[2], quaternion);
        Rotations.quaternionToVector(
            quaternion[0], quaternion[1], quaternion[2], quaternion[3], result);
        assertArrayEquals(vector, result, tolerance, () -> "by quaternion: " + input);
        double[] matrix = new double[9];
        Rotations.vectorToMatrix(vector[0], vector[1], vector[2], matrix);
        Rotations.matrixToVector(matrix, result);
        assertArrayEquals(vector, result, tolerance + 1e-14, () -> "by matrix: " + input);
      }
    }
  }

  @Test
  void matrixSurvivesTheWayThroughQuaternion() {
    Random random = new Random(28);
    double[] matrix = new double[9];
    double[] quaternion = new double[4];
    double[] again = new double[9];
    for (double angle : AROUND_HALF_A_TURN) {
      for (int n = 0; n < CASES; n++) {
        double[] axis = Samples.axis(random);
        Rotations.vectorToMatrix(angle * axis[0], angle * axis[1], angle * axis[2], matrix);
        Rotations.matrixToQuaternion(matrix, quaternion);
        double w = quaternion[0];
        double x = quaternion[1];
        double y = quaternion[2];
        double z = quaternion[3];
        String input = angle + " about " + axis[0] + ", " + axis[1] + ", " + axis[2];
        assertTrue(w >= -Rotations.HALF_TURN_BAND, input);
        assertEquals(1, w * w + x * x + y * y + z * z, 1e-15, input);
        Rotations.quaternionToMatrix(w, x, y, z, again);
        assertArrayEquals(matrix, again, 4e-15, () -> input);
      }
    }
  }

  @Test
  void noRotationIsExactlyNoneInEveryForm() {
    double[] identity = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    double[] matrix = new double[9];
    double[] quaternion = new double[4];
    double[] three = new double[3];
    Rotations.vectorToMatrix(0, 0, 0, matrix);
    assertArrayEquals(identity, matrix);
    Rotations.rpyToMatrix(0, 0, 0, matrix);
    assertArrayEquals(new double[9], minus(identity, matrix));
    Rotations.matrixToQuaternion(identity, quaternion);
    assertArrayEquals(new double[] {1, 0, 0, 0}, quaternion);
    Rotations.matrixToVector(identity, three);
    assertArrayEquals(new double[3], three);
    Rotations.matrixToRpy(identity, three);
    assertArrayEquals(new double[3], minus(new double[3], three));
  }

  @Test
  void rotationsAroundHalfATurnSurviveTheWayThroughEveryForm() {
    Random random = new Random(29);
    double[] matrix = new double[9];
    double[] again = new double[9];
    double[] three = new double[3];
    for (double angle : AROUND_HALF_A_TURN) {
      for (int n = 0; n < CASES; n++) {
        double[] axis = Samples.axis(random);
        if (n < 3) {
          axis = new double[3];
          axis[n] = 1;
        }
        String input = angle + " about " + axis[0] + ", " + axis[1] + ", " + axis[2];
        Rotations.vectorToMatrix(angle * axis[0], angle * axis[1], angle * axis[2], matrix);
        Rotations.matrixToVector(matrix, three);
        Rotations.vectorToMatrix(three[0], three[1], three[2], again);
        assertArrayEquals(matrix, again, 4e-15, () -> "by vector: " + input);
        Rotations.matrixToRpy(matrix, three);
        Rotations.rpyToMatrix(three[0], three[1], three[2], again);
        assertArrayEquals(matrix, again, 4e-15, () -> "by roll, pitch and yaw: " + input);
      }
    }
  }

  @Test
  void matrixAgreesWithRodriguesFormula() {
    Random random = new Random(22);
    double[] matrix = new double[9];
    for (int n = 0; n < CASES; n++) {
      double[] axis = Samples.axis(random);
      double angle = 10 * random.nextDouble();
      Rotations.vectorToMatrix(angle * axis[0], angle * axis[1], angle * axis[2], matrix);
      double[] expected =
          Samples.rotation(angle * axis[0], angle * axis[1], angle * axis[2]).getDDRM().getData();
      assertArrayEquals(
          expected, matrix, 1e-14, () -> angle + " about " + axis[0] + ", " + axis[1]);
    }
  }

  @Test
  void halfATurnGetsTheAxisWhoseFirstComponentIsPositive() {
    Random random = new Random(23);
    double[] matrix = new double[9];
    double[] result = new double[3];
    for (int n = 0; n < CASES; n++) {
      double[] axis = Samples.axis(random);
      double sign = Math.signum(axis[0]);
      for (double slack : new double[] {-1e-13, 0, 1e-13}) {
        double angle = Math.PI + slack;
        Rotations.vectorToMatrix(angle * axis[0], angle * axis[1], angle * axis[2], matrix);
        Rotations.matrixToVector(matrix, result);
        double[] expected = {
          sign * Math.PI * axis[0], sign * Math.PI * axis[1], sign * Math.PI * axis[2]
        };
        assertArrayEquals(
            expected, result, 2e-13, () -> angle + " about " + axis[0] + ", " + axis[1]);
      }
    }
  }

  @Test
  void halfATurnAboutAnAxisOfTheFrameIsPositive() {
    double[] result = new double[3];
    double[][] matrices = {
      {1, 0, 0, 0, -1, 0, 0, 0, -1}, {-1, 0, 0, 0, 1, 0, 0, 0, -1}, {-1, 0, 0, 0, -1, 0, 0, 0, 1}
    };
    for (int axis = 0; axis < 3; axis++) {
      Rotations.matrixToVector(matrices[axis], result);
      double[] expected = new double[3];
      expected[axis] = Math.PI;
      assertArrayEquals(expected, result, 1e-15);
    }
    Pose flipped = Poses.trans(new Pose(0, 0, 0, 0, -Math.PI, 0), Pose.ZERO);
    assertEquals(Math.PI, flipped.ry(), 1e-15);
  }

  @Test
  void justBeyondHalfATurnTheShorterWayIsTaken() {
    Random random = new Random(24);
    for (double beyond : new double[] {1e-9, 1e-6, 1, Math.PI - 1e-9, Math.PI, 4, 40}) {
      for (int n = 0; n < CASES; n++) {
        double[] axis = Samples.axis(random);
        double angle = Math.PI + beyond;
        double[] vector = new double[3];
        double[] matrix = new double[9];
        Rotations.vectorToMatrix(angle * axis[0], angle * axis[1], angle * axis[2], matrix);
        Rotations.matrixToVector(matrix, vector);
        double rest = Math.IEEEremainder(angle, 2 * Math.PI);
        double[] expected = {rest * axis[0], rest * axis[1], rest * axis[2]};
        assertArrayEquals(
            expected, vector, 2e-14, () -> angle + " about " + axis[0] + ", " + axis[1]);
      }
    }
  }

  @Test
  void rpySurvivesTheWayThroughRotationVector() {
    Random random = new Random(25);
    for (int n = 0; n < CASES; n++) {
      double[] rpy = {
        2 * Math.PI * (random.nextDouble() - 0.5),
        3 * (random.nextDouble() - 0.5),
        2 * Math.PI * (random.nextDouble() - 0.5)
      };
      double[] vector = new double[3];
      double[] result = new double[3];
      Rotations.rpyToVector(rpy[0], rpy[1], rpy[2], vector);
      Rotations.vectorToRpy(vector[0], vector[1], vector[2], result);
      assertArrayEquals(
          rpy, result, 1e-13, () -> "roll " + rpy[0] + " pitch " + rpy[1] + " yaw " + rpy[2]);
    }
  }

  @Test
  void rpyMatrixIsTheProductOfTurnsAboutZAndYAndX() {
    Random random = new Random(26);
    double[] matrix = new double[9];
    for (int n = 0; n < CASES; n++) {
      double roll = 6 * random.nextDouble() - 3;
      double pitch = 6 * random.nextDouble() - 3;
      double yaw = 6 * random.nextDouble() - 3;
      Rotations.rpyToMatrix(roll, pitch, yaw, matrix);
      SimpleMatrix expected =
          Samples.rotation(0, 0, yaw)
              .mult(Samples.rotation(0, pitch, 0))
              .mult(Samples.rotation(roll, 0, 0));
      assertArrayEquals(
          expected.getDDRM().getData(), matrix, 1e-14, () -> roll + ", " + pitch + ", " + yaw);
    }
  }

  @Test
  void gimbalLockKeepsTheRotationWithoutRoll() {
    Random random = new Random(27);
    for (double slack : new double[] {0, 1e-15, 1e-13, 1e-11, 1e-9, 1e-6}) {
      for (int n = 0; n < CASES; n++) {
        double pitch = (random.nextBoolean() ? 1 : -1) * (Math.PI / 2 - slack);
        double roll = 6 * random.nextDouble() - 3;
        double yaw = 6 * random.nextDouble() - 3;
        double[] matrix = new double[9];
        double[] rpy = new double[3];
        double[] again = new double[9];
        Rotations.rpyToMatrix(roll, pitch, yaw, matrix);
        Rotations.matrixToRpy(matrix, rpy);
        Rotations.rpyToMatrix(rpy[0], rpy[1], rpy[2], again);
        String input = roll + ", " + pitch + ", " + yaw;
        assertArrayEquals(matrix, again, 3e-12, () -> input);
        if (slack < 1e-12) {
          assertEquals(0, rpy[0], 0.0, input);
        }
      }
    }
  }

  /** The difference, which has no negative zeros where the numbers are equal. */
  private static double[] minus(double[] a, double[] b) {
    double[] difference = new double[a.length];
    for (int i = 0; i < a.length; i++) {
      difference[i] = a[i] - b[i];
    }
    return difference;
  }
}
