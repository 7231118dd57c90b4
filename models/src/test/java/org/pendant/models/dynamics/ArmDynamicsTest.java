package org.pendant.models.dynamics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;

final class ArmDynamicsTest {
  private static final int N = Joints.COUNT;

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ArmDynamics dynamics = new ArmDynamics(arm);
  private final SplittableRandom random = new SplittableRandom(7);

  private double[] random(double size) {
    double[] numbers = new double[N];
    for (int i = 0; i < N; i++) {
      numbers[i] = size * (2 * random.nextDouble() - 1);
    }
    return numbers;
  }

  private static Payload payload(SplittableRandom random) {
    return new Payload(
        5 * random.nextDouble(), 0.1, -0.05, 0.2, 0.02, 0.03, 0.04, 0.001, -0.002, 0.003);
  }

  @Test
  void forwardDynamicsUndoesInverseDynamics() {
    for (int n = 0; n < 200; n++) {
      dynamics.setPayload(payload(random));
      double[] q = random(3);
      double[] qd = random(3);
      double[] qdd = random(10);
      double[] torque = new double[N];
      double[] back = new double[N];
      dynamics.inverse(q, qd, qdd, torque);
      dynamics.forward(q, qd, torque, false, back);
      assertArrayEquals(qdd, back, 1e-8);
    }
  }

  @Test
  void rotorsMakeTheDiagonalLargerByTheirInertia() {
    double[] q = random(3);
    DMatrixRMaj without = new DMatrixRMaj(N, N);
    DMatrixRMaj with = new DMatrixRMaj(N, N);
    dynamics.mass(q, false, without);
    dynamics.mass(q, true, with);
    for (int row = 0; row < N; row++) {
      for (int i = 0; i < N; i++) {
        double rotor = row == i ? arm.actuators().get(i).rotorInertiaKgM2() : 0;
        assertEquals(without.get(row, i) + rotor, with.get(row, i), 1e-15);
      }
    }
    double[] torque = random(50);
    double[] qdd = new double[N];
    double[] given = new double[N];
    dynamics.forward(q, random(0), torque, true, qdd);
    dynamics.inverse(q, random(0), qdd, given);
    for (int i = 0; i < N; i++) {
      given[i] += arm.actuators().get(i).rotorInertiaKgM2() * qdd[i];
    }
    assertArrayEquals(torque, given, 1e-9);
  }

  @Test
  void massMatrixIsSymmetricAndPositiveDefinite() {
    DMatrixRMaj mass = new DMatrixRMaj(N, N);
    for (String id : ArmLibrary.ids()) {
      ArmDynamics each = new ArmDynamics(ArmLibrary.load(id));
      for (int n = 0; n < 100; n++) {
        each.mass(random(6), false, mass);
        assertTrue(MatrixFeatures_DDRM.isSymmetric(mass, 0), id);
        assertTrue(MatrixFeatures_DDRM.isPositiveDefinite(mass.copy()), id);
      }
    }
  }

  @Test
  void powerOfTheTorquesIsTheChangeOfEnergy() {
    double step = 1e-6;
    double[] before = new double[N];
    double[] beforeSpeed = new double[N];
    double[] after = new double[N];
    double[] afterSpeed = new double[N];
    for (int n = 0; n < 50; n++) {
      dynamics.setPayload(payload(random));
      dynamics.setGravity(random(10)[0], random(10)[0], random(10)[0]);
      double[] q = random(3);
      double[] qd = random(2);
      double[] qdd = random(5);
      double[] torque = new double[N];
      dynamics.inverse(q, qd, qdd, torque);
      double power = 0;
      for (int i = 0; i < N; i++) {
        power += torque[i] * qd[i];
        before[i] = q[i] - step * qd[i];
        after[i] = q[i] + step * qd[i];
        beforeSpeed[i] = qd[i] - step * qdd[i];
        afterSpeed[i] = qd[i] + step * qdd[i];
      }
      double change = energy(after, afterSpeed) - energy(before, beforeSpeed);
      assertEquals(power, change / (2 * step), 1e-4 * (1 + Math.abs(power)));
    }
  }

  private double energy(double[] q, double[] qd) {
    return dynamics.kineticEnergyJ(q, qd) + dynamics.potentialEnergyJ(q);
  }

  @Test
  void aFreelySwingingArmKeepsItsEnergy() {
    double[] q = {0.2, -1, 1.2, -0.8, 0.6, 0.1};
    double[] qd = new double[N];
    double[] qdd = new double[N];
    double[] none = new double[N];
    double step = 1e-4;
    double start = energy(q, qd);
    double largestKinetic = 0;
    for (int n = 0; n < 10_000; n++) {
      dynamics.forward(q, qd, none, true, qdd);
      for (int i = 0; i < N; i++) {
        qd[i] += step * qdd[i];
        q[i] += step * qd[i];
      }
      largestKinetic = Math.max(largestKinetic, kineticWithRotors(q, qd));
    }
    double end = kineticWithRotors(q, qd) + dynamics.potentialEnergyJ(q);
    assertTrue(largestKinetic > 20, "it does swing");
    assertEquals(start, end, 0.01 * largestKinetic);
  }

  private double kineticWithRotors(double[] q, double[] qd) {
    double energy = dynamics.kineticEnergyJ(q, qd);
    for (int i = 0; i < N; i++) {
      energy += 0.5 * arm.actuators().get(i).rotorInertiaKgM2() * qd[i] * qd[i];
    }
    return energy;
  }

  @Test
  void theFlangeAcceleratesAsItsJacobianSays() {
    Jacobian jacobian = new Jacobian(arm.dh());
    double[] now = new double[Jacobian.SIZE];
    double[] before = new double[Jacobian.SIZE];
    double[] after = new double[Jacobian.SIZE];
    double[] acceleration = new double[6];
    double step = 1e-6;
    for (int n = 0; n < 100; n++) {
      double[] q = random(3);
      double[] qd = random(2);
      double[] qdd = random(5);
      dynamics.flangeAcceleration(q, qd, qdd, acceleration);
      jacobian.at(q, Pose.ZERO, now);
      jacobian.at(moved(q, qd, -step), Pose.ZERO, before);
      jacobian.at(moved(q, qd, step), Pose.ZERO, after);
      for (int row = 0; row < 6; row++) {
        double sum = 0;
        for (int i = 0; i < N; i++) {
          double change = (after[N * row + i] - before[N * row + i]) / (2 * step);
          sum += now[N * row + i] * qdd[i] + change * qd[i];
        }
        assertEquals(sum, acceleration[row], 1e-6);
      }
    }
  }

  private static double[] moved(double[] q, double[] qd, double timeS) {
    double[] moved = new double[N];
    for (int i = 0; i < N; i++) {
      moved[i] = q[i] + timeS * qd[i];
    }
    return moved;
  }

  @Test
  void aPayloadTakesWhatItAddsToTheTorques() {
    ForwardKinematics forward = new ForwardKinematics(arm.dh());
    Jacobian jacobian = new Jacobian(arm.dh());
    double[] wrench = new double[6];
    double[] felt = new double[6];
    double[] twist = new double[6];
    double[] flange = new double[12];
    double[] columns = new double[Jacobian.SIZE];
    for (int n = 0; n < 100; n++) {
      Payload payload = payload(random);
      double[] q = random(3);
      double[] qd = random(2);
      double[] qdd = random(5);
      double[] without = new double[N];
      double[] with = new double[N];
      dynamics.setPayload(Payload.NONE);
      dynamics.inverse(q, qd, qdd, without);
      dynamics.setPayload(payload);
      dynamics.inverse(q, qd, qdd, with);
      dynamics.flangeAcceleration(q, qd, qdd, felt);
      felt[2] += ArmDynamics.STANDARD_GRAVITY_M_PER_S2;
      forward.flange(q, flange);
      jacobian.at(q, Pose.ZERO, columns);
      Jacobian.twist(columns, qd, twist);
      double[] turning = {twist[3], twist[4], twist[5]};
      PayloadWrench.of(payload, flange, turning, felt, wrench);
      for (int i = 0; i < N; i++) {
        double power = 0;
        for (int row = 0; row < 6; row++) {
          power += columns[N * row + i] * wrench[row];
        }
        assertEquals(with[i] - without[i], power, 1e-9);
      }
    }
  }

  @Test
  void impossiblePayloadsAreRefused() {
    assertEquals(
        "payload: mass is -1.0 kg, must be at least 0",
        assertThrows(IllegalArgumentException.class, () -> Payload.of(-1, 0, 0, 0)).getMessage());
    assertThrows(IllegalArgumentException.class, () -> Payload.of(Double.NaN, 0, 0, 0));
    assertThrows(IllegalArgumentException.class, () -> Payload.of(1, 0, Double.NaN, 0));
  }

  @Test
  void halfWayBetweenTwoPayloadsEveryNumberIsTheMean() {
    Payload from = new Payload(2, 0, 0.2, 0, 0.1, 0.2, 0.3, 0, 0, 0);
    Payload to = new Payload(4, 0.1, 0, 0, 0.3, 0.2, 0.1, 0.02, 0, 0);
    assertEquals(new Payload(3, 0.05, 0.1, 0, 0.2, 0.2, 0.2, 0.01, 0, 0), from.between(to, 0.5));
    assertEquals(from, from.between(to, 0));
  }
}
