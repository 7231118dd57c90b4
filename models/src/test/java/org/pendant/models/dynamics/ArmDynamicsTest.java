package org.pendant.models.dynamics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.LinkMass;
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
  void aPostureIsReckonedAnewWhereOneOfItsAnglesHasChanged() {
    double[] q = random(3);
    double[] zero = new double[N];
    double[] torque = new double[N];
    double[] ofNew = new double[N];
    DMatrixRMaj mass = new DMatrixRMaj(N, N);
    DMatrixRMaj massOfNew = new DMatrixRMaj(N, N);
    for (int n = 0; n < 100; n++) {
      q[random.nextInt(N)] = 6 * random.nextDouble() - 3;
      dynamics.mass(q, false, mass);
      dynamics.inverse(q, zero, zero, torque);
      ArmDynamics unused = new ArmDynamics(arm);
      unused.inverse(q, zero, zero, ofNew);
      unused.mass(q, false, massOfNew);
      assertArrayEquals(ofNew, torque);
      assertArrayEquals(massOfNew.data, mass.data);
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
  void theFlangeFeelsGravityAlongItsOwnAxes() {
    double[] q = {0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0};
    dynamics.inverse(q, new double[N], new double[N], new double[N]);
    assertEquals(0, dynamics.flangeMotion().feltMPerS2(0), 1e-12);
    assertEquals(0, dynamics.flangeMotion().feltMPerS2(1), 1e-12);
    assertEquals(-9.82, dynamics.flangeMotion().feltMPerS2(2), 1e-12, "tool points down");
    assertThrows(IllegalArgumentException.class, () -> dynamics.flangeMotion().feltMPerS2(3));
  }

  @Test
  void theFlangeFeelsTheAccelerationOfItsJoints() {
    ForwardKinematics forward = new ForwardKinematics(arm);
    double step = 1e-4;
    double[] before = new double[12];
    double[] now = new double[12];
    double[] after = new double[12];
    for (int n = 0; n < 100; n++) {
      double[] q = random(3);
      double[] qd = random(2);
      double[] qdd = random(5);
      dynamics.inverse(q, qd, qdd, new double[N]);
      forward.flange(q, now);
      forward.flange(moved(q, qd, qdd, -step), before);
      forward.flange(moved(q, qd, qdd, step), after);
      double[] felt = new double[3];
      for (int row = 0; row < 3; row++) {
        felt[row] = (after[9 + row] - 2 * now[9 + row] + before[9 + row]) / (step * step);
      }
      felt[2] += ArmDynamics.STANDARD_GRAVITY_M_PER_S2;
      for (int axis = 0; axis < 3; axis++) {
        double along = now[axis] * felt[0] + now[3 + axis] * felt[1] + now[6 + axis] * felt[2];
        assertEquals(along, dynamics.flangeMotion().feltMPerS2(axis), 1e-5);
      }
    }
  }

  @Test
  void theMotionOfTheFlangeIsTheSameWithoutTorques() {
    ArmDynamics alone = new ArmDynamics(arm);
    alone.setGravity(1, 2, 9);
    dynamics.setGravity(1, 2, 9);
    for (int n = 0; n < 100; n++) {
      double[] q = random(3);
      double[] qd = random(2);
      double[] qdd = random(5);
      dynamics.inverse(q, qd, qdd, new double[N]);
      alone.moveFlange(q, qd, qdd);
      double[] expected = new double[6];
      double[] load = new double[6];
      Payload payload = payload(random);
      dynamics.flangeMotion().loadOf(payload, expected);
      alone.flangeMotion().loadOf(payload, load);
      assertArrayEquals(expected, load);
    }
  }

  private static double[] moved(double[] q, double[] qd, double[] qdd, double timeS) {
    double[] moved = new double[N];
    for (int i = 0; i < N; i++) {
      moved[i] = q[i] + timeS * qd[i] + 0.5 * timeS * timeS * qdd[i];
    }
    return moved;
  }

  @Test
  void aPayloadLoadsTheFlangeWithWhatItAddsToTheTorques() {
    ForwardKinematics forward = new ForwardKinematics(arm);
    Jacobian jacobian = new Jacobian(arm);
    double[] load = new double[6];
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
      dynamics.flangeMotion().loadOf(payload, load);
      dynamics.setPayload(payload);
      dynamics.inverse(q, qd, qdd, with);
      forward.flange(q, flange);
      jacobian.at(q, Pose.ZERO, columns);
      for (int i = 0; i < N; i++) {
        double given = 0;
        for (int row = 0; row < 6; row++) {
          given += columns[N * row + i] * alongBase(row, flange, load);
        }
        assertEquals(without[i] - with[i], given, 1e-9);
      }
    }
  }

  private static double alongBase(int row, double[] flange, double[] load) {
    int from = row < 3 ? 0 : 3;
    int axis = 3 * (row % 3);
    return flange[axis] * load[from]
        + flange[axis + 1] * load[from + 1]
        + flange[axis + 2] * load[from + 2];
  }

  @Test
  void aPayloadAtTheLastLinksCentreOfMassIsAHeavierLink() {
    LinkMass wrist = arm.links().get(N - 1);
    Payload payload =
        new Payload(
            2, wrist.comXM(), wrist.comYM(), wrist.comZM(), 0.02, 0.03, 0.04, 0.001, -0.002, 0.003);
    LinkMass heavier =
        new LinkMass(
            "wrist 3 with payload",
            wrist.massKg() + 2,
            wrist.comXM(),
            wrist.comYM(),
            wrist.comZM(),
            wrist.ixx() + 0.02,
            wrist.ixy() + 0.001,
            wrist.ixz() - 0.002,
            wrist.iyy() + 0.03,
            wrist.iyz() + 0.003,
            wrist.izz() + 0.04);
    ArmDynamics welded = new ArmDynamics(withLastLink(heavier));
    dynamics.setPayload(payload);
    double[] q = random(3);
    double[] qd = random(2);
    double[] qdd = random(5);
    double[] expected = new double[N];
    double[] torque = new double[N];
    welded.inverse(q, qd, qdd, expected);
    dynamics.inverse(q, qd, qdd, torque);
    assertArrayEquals(expected, torque, 1e-10);
    DMatrixRMaj expectedMass = new DMatrixRMaj(N, N);
    DMatrixRMaj mass = new DMatrixRMaj(N, N);
    welded.mass(q, false, expectedMass);
    dynamics.mass(q, false, mass);
    assertArrayEquals(expectedMass.data, mass.data, 1e-12);
  }

  private ArmDescription withLastLink(LinkMass link) {
    List<LinkMass> links = new ArrayList<>(arm.links());
    links.set(N - 1, link);
    return new ArmDescription(
        arm.id(),
        arm.displayName(),
        arm.series(),
        arm.dh(),
        arm.calibration(),
        arm.joints(),
        arm.actuators(),
        links,
        arm.payloadKg(),
        arm.reachM(),
        arm.status(),
        arm.notes());
  }

  @Test
  void takingThePayloadOffLeavesTheArmAsItWas() {
    double[] q = random(3);
    double[] before = new double[N];
    double[] after = new double[N];
    dynamics.gravity(q, before);
    dynamics.setPayload(payload(random));
    dynamics.setPayload(Payload.NONE);
    dynamics.gravity(q, after);
    assertArrayEquals(before, after, 0);
  }

  @Test
  void accelerationsMayReplaceTheTorques() {
    double[] q = random(3);
    double[] qd = random(2);
    double[] torque = random(50);
    double[] qdd = new double[N];
    dynamics.forward(q, qd, torque, true, qdd);
    dynamics.forward(q, qd, torque, true, torque);
    assertArrayEquals(qdd, torque, 0);
  }

  @Test
  void impossiblePayloadsAreRefused() {
    assertRefused("payload: mass is -1.0 kg, must be at least 0", () -> Payload.of(-1, 0, 0, 0));
    assertRefused(
        "payload: mass is NaN kg, must be at least 0", () -> Payload.of(Double.NaN, 0, 0, 0));
    assertRefused(
        "payload: mass is Infinity, must be a finite number",
        () -> Payload.of(Double.POSITIVE_INFINITY, 0, 0, 0));
    assertRefused(
        "payload: cog y is NaN, must be a finite number", () -> Payload.of(1, 0, Double.NaN, 0));
    assertRefused(
        "payload: Iyz is -Infinity, must be a finite number",
        () -> new Payload(1, 0, 0, 0, 0, 0, 0, 0, 0, Double.NEGATIVE_INFINITY));
  }

  private static void assertRefused(String message, Executable call) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, call).getMessage());
  }

  @Test
  void halfWayBetweenTwoPayloadsEveryNumberIsTheMean() {
    Payload from = new Payload(2, 0, 0.2, 0, 0.1, 0.2, 0.3, 0, 0, 0);
    Payload to = new Payload(4, 0.1, 0, 0, 0.3, 0.2, 0.1, 0.02, 0, 0);
    assertEquals(new Payload(3, 0.05, 0.1, 0, 0.2, 0.2, 0.2, 0.01, 0, 0), from.between(to, 0.5));
    assertEquals(from, from.between(to, 0));
  }
}
