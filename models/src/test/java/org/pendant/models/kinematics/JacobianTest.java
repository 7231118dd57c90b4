package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

class JacobianTest {
  private static final int CASES = 1000;

  private final DhLengths dh = Arms.UR5E.dh();
  private final ForwardKinematics forward = new ForwardKinematics(Arms.UR5E);
  private final Jacobian jacobian = new Jacobian(Arms.UR5E);

  @Test
  void columnsAreTheFiniteDifferencesOfTheTcpPose() {
    Random random = new Random(71);
    double step = 1e-5;
    double[] j = new double[Jacobian.SIZE];
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      Pose offset = Arms.tcp(random);
      jacobian.at(q.toArray(), offset, j);
      for (int i = 0; i < Joints.COUNT; i++) {
        Pose after = forward.tcpPose(q.with(i, q.get(i) + step), offset);
        Pose before = forward.tcpPose(q.with(i, q.get(i) - step), offset);
        Pose difference = Poses.sub(after, before);
        for (int row = 0; row < Pose.SIZE; row++) {
          String entry = "row " + row + ", joint " + i + " at " + q + " with " + offset;
          assertEquals(difference.get(row) / (2 * step), j[6 * row + i], 1e-9, entry);
        }
      }
    }
  }

  @Test
  void derivativeIsTheFiniteDifferenceOfTheJacobianAlongTheMotion() {
    Random random = new Random(75);
    double step = 1e-5;
    double[] before = new double[Jacobian.SIZE];
    double[] after = new double[Jacobian.SIZE];
    double[] derivative = new double[Jacobian.SIZE];
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      Joints qd = Arms.joints(random);
      Pose offset = Arms.tcp(random);
      jacobian.derivative(q.toArray(), qd.toArray(), offset, derivative);
      jacobian.at(moved(q, qd, -step), offset, before);
      jacobian.at(moved(q, qd, step), offset, after);
      for (int i = 0; i < Jacobian.SIZE; i++) {
        double expected = (after[i] - before[i]) / (2 * step);
        String entry = "entry " + i + " at " + q + " moving at " + qd + " with " + offset;
        // the third derivative times the square of the step
        assertEquals(expected, derivative[i], 3e-7, entry);
      }
    }
  }

  @Test
  void anArmAtRestHasAConstantJacobian() {
    double[] derivative = new double[Jacobian.SIZE];
    jacobian.derivative(
        new double[] {0.1, -1.5, 1.2, -1, 0.4, 0.3}, new double[6], Pose.ZERO, derivative);
    assertArrayEquals(new double[Jacobian.SIZE], derivative, 0.0);
  }

  @Test
  void torquesDoTheWorkOfTheWrench() {
    Random random = new Random(76);
    double[] j = new double[Jacobian.SIZE];
    double[] twist = new double[Joints.COUNT];
    double[] torque = new double[Joints.COUNT];
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      double[] qd = Arms.joints(random).toArray();
      double[] wrench = Arms.joints(random).toArray();
      jacobian.at(q.toArray(), Arms.tcp(random), j);
      Jacobian.twist(j, qd, twist);
      Jacobian.transposed(j, wrench, torque);
      assertEquals(dot(wrench, twist), dot(torque, qd), 1e-12, q::toString);
    }
  }

  @Test
  void aLoadOnTheStretchedArmWeighsOnTheShoulderWithTheWholeLength() {
    double[] j = new double[Jacobian.SIZE];
    double[] torque = new double[Joints.COUNT];
    jacobian.at(new double[6], Pose.ZERO, j);
    Jacobian.transposed(j, new double[] {0, 0, -10, 0, 0, 0}, torque);
    // flange at x = -0.8172 m, shoulder axis along -y: the load turns it by -10 N times -0.8172 m
    assertArrayEquals(new double[] {0, 8.172, 3.922, 0, 0, 0}, torque, 1e-12);
  }

  @Test
  void determinantIsTheProductOfTheSingularityMeasures() {
    Random random = new Random(72);
    double[] j = new double[Jacobian.SIZE];
    double reach = Math.abs(dh.a2()) + Math.abs(dh.a3());
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      jacobian.at(q.toArray(), Pose.ZERO, j);
      double product = dh.a2() * dh.a3() * reach;
      for (Singularity singularity : Singularity.values()) {
        product *= singularity.measure(dh, q);
      }
      assertEquals(product, Math.abs(matrix(j).determinant()), 1e-14, q::toString);
    }
  }

  @Test
  void oneFactorisationAnswersForSeveralTwists() {
    Random random = new Random(74);
    double[] j = new double[Jacobian.SIZE];
    double[] qd = new double[Joints.COUNT];
    double[] alone = new double[Joints.COUNT];
    for (int n = 0; n < CASES; n++) {
      jacobian.at(Arms.joints(random).toArray(), Pose.ZERO, j);
      assertTrue(jacobian.factorise(j));
      for (int k = 0; k < 3; k++) {
        double[] twist = Arms.joints(random).toArray();
        jacobian.solve(twist, qd);
        assertTrue(new Jacobian(Arms.UR5E).solve(j, twist, alone));
        assertArrayEquals(alone, qd);
      }
    }
  }

  @Test
  void speedsFoundGiveTheTwistAsked() {
    Random random = new Random(73);
    double[] j = new double[Jacobian.SIZE];
    double[] qd = new double[Joints.COUNT];
    double[] given = new double[Joints.COUNT];
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      double[] twist = Arms.joints(random).toArray();
      jacobian.at(q.toArray(), Pose.ZERO, j);
      assertTrue(jacobian.solve(j, twist, qd), q::toString);
      Jacobian.twist(j, qd, given);
      double largest = 1;
      for (double speed : qd) {
        largest = Math.max(largest, Math.abs(speed));
      }
      assertArrayEquals(twist, given, 1e-13 * largest, q::toString);
    }
  }

  @Test
  void dampedSpeedsSolveTheDampedProblem() {
    Random random = new Random(74);
    double damping = 0.05;
    double[] j = new double[Jacobian.SIZE];
    double[] qd = new double[Joints.COUNT];
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      SimpleMatrix twist = new SimpleMatrix(Arms.joints(random).toArray());
      jacobian.at(q.toArray(), Pose.ZERO, j);
      jacobian.solveDamped(j, twist.getDDRM().getData(), damping, qd);
      SimpleMatrix a = matrix(j);
      SimpleMatrix expected =
          a.transpose()
              .mult(a)
              .plus(SimpleMatrix.identity(6).scale(damping * damping))
              .solve(a.transpose().mult(twist));
      assertArrayEquals(expected.getDDRM().getData(), qd, 1e-9, q::toString);
    }
  }

  @Test
  void aSingularArmIsReportedAndDampingPassesThrough() {
    double[] j = new double[Jacobian.SIZE];
    double[] qd = new double[Joints.COUNT];
    double[] twist = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    jacobian.at(new double[] {0.1, -1.5, 1.2, -1, 0, 0.3}, Pose.ZERO, j);
    assertFalse(jacobian.solve(j, twist, qd));
    jacobian.solveDamped(j, twist, 0.1, qd);
    for (double speed : qd) {
      assertTrue(Math.abs(speed) < 10);
    }
  }

  @Test
  void dampingMustBePositive() {
    double[] j = new double[Jacobian.SIZE];
    assertThrows(
        IllegalArgumentException.class,
        () -> jacobian.solveDamped(j, new double[6], 0, new double[6]));
  }

  private static double[] moved(Joints q, Joints qd, double timeS) {
    double[] moved = q.toArray();
    for (int i = 0; i < moved.length; i++) {
      moved[i] += timeS * qd.get(i);
    }
    return moved;
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  private static SimpleMatrix matrix(double[] j) {
    return new SimpleMatrix(6, 6, true, j);
  }
}
