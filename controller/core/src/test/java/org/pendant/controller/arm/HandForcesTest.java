package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.world.HandGrip;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

class HandForcesTest {
  private static final double STEP_RAD = 1e-6;
  private static final Vector3 POINT = new Vector3(0.03, -0.05, 0.08);
  private static final Vector3 FORCE = new Vector3(7, -11, 13);

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final HandGrip grip = new HandGrip();
  private final HandForces load = new HandForces(grip, arm, forward);
  private final double[] q = Rig.ELSEWHERE.toArray();
  private final double[] torque = new double[Joints.COUNT];
  private final double[] wrench = new double[6];

  private void add() {
    load.add(q, new double[Joints.COUNT], torque, wrench);
  }

  /** The work of the force per radian of each joint, by moving it a little. */
  private double work(int link, int joint) {
    double[] there = q.clone();
    there[joint] += STEP_RAD;
    double[] from = place(link, q);
    double[] to = place(link, there);
    return ((to[0] - from[0]) * FORCE.x()
            + (to[1] - from[1]) * FORCE.y()
            + (to[2] - from[2]) * FORCE.z())
        / STEP_RAD;
  }

  private double[] place(int link, double[] at) {
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    forward.frames(at, frames);
    double[] f = frames[link];
    double[] place = new double[3];
    for (int row = 0; row < 3; row++) {
      place[row] =
          f[9 + row]
              + f[3 * row] * POINT.x()
              + f[3 * row + 1] * POINT.y()
              + f[3 * row + 2] * POINT.z();
    }
    return place;
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5})
  void eachJointFeelsTheWorkThatTheForceDoesWhenItTurns(int link) {
    grip.push(link, POINT, FORCE);
    add();
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      assertEquals(work(link, joint), torque[joint], 1e-4, "joint " + joint);
    }
  }

  @Test
  void aHandOnTheLastLinkIsFeltByTheFlange() {
    grip.push(5, POINT, FORCE);
    add();
    double[] expected = new double[Joints.COUNT];
    double[] jacobian = new double[Jacobian.SIZE];
    new Jacobian(arm).at(q, Pose.ZERO, jacobian);
    Jacobian.transposed(jacobian, wrench, expected);
    assertArrayEquals(expected, torque, 1e-9);
    assertEquals(FORCE.x(), wrench[0]);
  }

  @Test
  void aHandBeforeTheFlangeIsNot() {
    grip.push(4, POINT, FORCE);
    add();
    assertArrayEquals(new double[6], wrench);
  }

  @Test
  void aPullAsksNoMoreOfAMotorThanItHasLeft() {
    grip.pull(5, new Vector3(0, 0.4, 0), new Vector3(50, 50, 50));
    add();
    boolean atLimit = false;
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      double most = 0.5 * arm.joints().get(joint).maxTorqueNm();
      assertTrue(Math.abs(torque[joint]) <= most + 1e-9, "joint " + joint + ": " + torque[joint]);
      atLimit |= Math.abs(torque[joint]) > most - 1e-9;
    }
    assertTrue(atLimit, "it pulls as hard as it may");
  }

  @Test
  void aHeldArmThatRestsNoticesTheHandAndComesBackWhenItIsGone() {
    Rig rig = new Rig("ur5e");
    rig.repeat(500, Rig.hold(Rig.START));
    rig.world.grip().push(2, new Vector3(0, 0, 0), new Vector3(0, 60, 0));
    assertTrue(rig.worstWhileHolding(50, Rig.START) > 1e-4, "gives way");
    rig.world.grip().letGo();
    rig.repeat(1000, Rig.hold(Rig.START));
    assertTrue(rig.distance(Rig.START) < 1e-4);
  }
}
