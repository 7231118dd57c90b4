package org.pendant.controller.state;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.Mounting;
import org.pendant.controller.box.ToolCentre;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** Against the dynamics of the arm, which know nothing of the base. */
class ArmForcesTest {
  private static final long SEED = 7;
  private static final int CASES = 200;
  private static final int N = Joints.COUNT;
  private static final Payload LOAD =
      new Payload(3, 0.05, -0.02, 0.1, 0.02, 0.03, 0.01, 0.001, -0.002, 0.003);
  private static final Mounting FLOOR = new Mounting(0, 0, 9.82, 0, 0, 0);

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics kinematics = new ForwardKinematics(arm);
  private final ArmDynamics dynamics = new ArmDynamics(arm);
  private final SplittableRandom random = new SplittableRandom(SEED);

  ArmForcesTest() {
    dynamics.setPayload(LOAD);
  }

  private Joints random(double most) {
    double[] values = new double[N];
    for (int i = 0; i < N; i++) {
      values[i] = random.nextDouble(-most, most);
    }
    return Joints.of(values);
  }

  private ArmState state(Joints q, Joints qd, Joints qdd) {
    return new ArmState(
        q,
        qd,
        qdd,
        q,
        qd,
        ToolCentre.FLANGE,
        arm,
        kinematics,
        ControlMode.POSITION,
        true,
        false,
        1,
        1,
        Optional.empty());
  }

  private static Joints moved(Joints from, Joints by, double share) {
    double[] sum = new double[N];
    for (int i = 0; i < N; i++) {
      sum[i] = from.get(i) + share * by.get(i);
    }
    return Joints.of(sum);
  }

  @Test
  void theBaseCarriesTheWeightOfAnArmAtRest() {
    double massKg = LOAD.massKg() + arm.links().stream().mapToDouble(l -> l.massKg()).sum();
    Wrench held = ArmForces.baseWrench(state(random(3), Joints.ZERO, Joints.ZERO), LOAD, FLOOR);
    assertEquals(0, held.fx(), 1e-12);
    assertEquals(0, held.fy(), 1e-12);
    assertEquals(massKg * 9.82, held.fz(), 1e-9);
  }

  @Test
  void theBaseTurnsTheArmAsTheFirstDriveDoes() {
    dynamics.setGravity(1, -2, 9);
    dynamics.setBaseAcceleration(0.5, 0.25, -1);
    Mounting moved = new Mounting(1, -2, 9, 0.5, 0.25, -1);
    double[] torqueNm = new double[N];
    for (int i = 0; i < CASES; i++) {
      Joints q = random(6);
      Joints qd = random(3);
      Joints qdd = random(20);
      dynamics.inverse(q.toArray(), qd.toArray(), qdd.toArray(), torqueNm);
      Wrench held = ArmForces.baseWrench(state(q, qd, qdd), LOAD, moved);
      assertEquals(torqueNm[0], held.mz(), 1e-9, q + " " + qd + " " + qdd);
    }
  }

  @Test
  void theForceOnTheBaseIsTheChangeOfMomentum() {
    double stepS = 1e-5;
    double[] before = new double[3];
    double[] after = new double[3];
    for (int i = 0; i < CASES; i++) {
      Joints q = random(6);
      Joints qd = random(2);
      Joints qdd = random(10);
      Joints lastQ = moved(moved(q, qd, -stepS), qdd, stepS * stepS / 2);
      Joints nextQ = moved(moved(q, qd, stepS), qdd, stepS * stepS / 2);
      dynamics.linearMomentum(lastQ.toArray(), moved(qd, qdd, -stepS).toArray(), before);
      dynamics.linearMomentum(nextQ.toArray(), moved(qd, qdd, stepS).toArray(), after);
      Wrench held = ArmForces.baseWrench(state(q, qd, qdd), LOAD, new Mounting(0, 0, 0, 0, 0, 0));
      String where = q + " " + qd + " " + qdd;
      assertEquals((after[0] - before[0]) / (2 * stepS), held.fx(), 1e-4, where);
      assertEquals((after[1] - before[1]) / (2 * stepS), held.fy(), 1e-4, where);
      assertEquals((after[2] - before[2]) / (2 * stepS), held.fz(), 1e-4, where);
    }
  }

  @Test
  void aPushOnTheFlangeIsFoundFromTheTorquesThatHoldAgainstIt() {
    Joints q = new Joints(0.3, -1.2, 1.4, -0.7, -1.1, 0.4);
    double[] matrix = new double[Jacobian.SIZE];
    new Jacobian(arm).at(q.toArray(), Pose.ZERO, matrix);
    double[] torqueNm = new double[N];
    Jacobian.transposed(matrix, new double[] {10, -20, 5, 1, 0.5, -2}, torqueNm);
    double[] held = new double[N];
    for (int i = 0; i < N; i++) {
      held[i] = -torqueNm[i];
    }
    Wrench found = ArmForces.flangeWrenchOf(state(q, Joints.ZERO, Joints.ZERO), Joints.of(held));
    assertEquals(10, found.fx(), 0.1);
    assertEquals(-20, found.fy(), 0.1);
    assertEquals(5, found.fz(), 0.1);
    assertEquals(-2, found.mz(), 0.1);
    assertEquals(
        Wrench.ZERO, ArmForces.flangeWrenchOf(state(q, Joints.ZERO, Joints.ZERO), Joints.ZERO));
  }
}
