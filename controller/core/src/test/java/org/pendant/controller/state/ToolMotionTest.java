package org.pendant.controller.state;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/** Against the Jacobian, its derivative, and differences of the elbow's place. */
class ToolMotionTest {
  private static final long SEED = 6;
  private static final int CASES = 1000;
  private static final int N = Joints.COUNT;

  private final ArmDescription arm = ArmLibrary.load("ur10e");
  private final ForwardKinematics kinematics = new ForwardKinematics(arm);
  private final SplittableRandom random = new SplittableRandom(SEED);

  private Joints random(double most) {
    double[] values = new double[N];
    for (int i = 0; i < N; i++) {
      values[i] = random.nextDouble(-most, most);
    }
    return Joints.of(values);
  }

  private Pose randomTool() {
    return new Pose(random.nextDouble(), random.nextDouble(), random.nextDouble(), 0.3, 0, -1);
  }

  private double elbow(Joints q, int axis) {
    double[][] frames = new double[N][Transforms.SIZE];
    kinematics.frames(q.toArray(), frames);
    return frames[1][9 + axis];
  }

  @Test
  void speedAndAccelerationOfTheTcpAreThoseOfTheJacobian() {
    Jacobian jacobian = new Jacobian(arm);
    double[] matrix = new double[Jacobian.SIZE];
    double[] derivative = new double[Jacobian.SIZE];
    double[] speed = new double[N];
    double[] byJoints = new double[N];
    double[] byMotion = new double[N];
    for (int i = 0; i < CASES; i++) {
      Joints q = random(6);
      Joints qd = random(3);
      Joints qdd = random(40);
      Pose tool = randomTool();
      jacobian.at(q.toArray(), tool, matrix);
      Jacobian.twist(matrix, qd.toArray(), speed);
      Jacobian.twist(matrix, qdd.toArray(), byJoints);
      jacobian.derivative(q.toArray(), qd.toArray(), tool, derivative);
      Jacobian.twist(derivative, qd.toArray(), byMotion);
      ToolMotion motion = ToolMotion.of(kinematics, q, qd, qdd, tool);
      for (int axis = 0; axis < N; axis++) {
        String where = q + " " + qd + " " + qdd + " " + tool + " axis " + axis;
        assertEquals(speed[axis], motion.speed().get(axis), 1e-11, where);
        assertEquals(byJoints[axis] + byMotion[axis], motion.acceleration().get(axis), 1e-9, where);
      }
    }
  }

  @Test
  void theElbowIsWhereItsFrameIsAndMovesAsItsPlaceChanges() {
    double stepS = 1e-6;
    for (int i = 0; i < CASES; i++) {
      Joints q = random(6);
      Joints qd = random(3);
      double[] next = new double[N];
      double[] last = new double[N];
      for (int joint = 0; joint < N; joint++) {
        next[joint] = q.get(joint) + stepS * qd.get(joint);
        last[joint] = q.get(joint) - stepS * qd.get(joint);
      }
      ToolMotion motion = ToolMotion.of(kinematics, q, qd, Joints.ZERO, Pose.ZERO);
      String where = q + " " + qd;
      assertEquals(elbow(q, 0), motion.elbowM().x(), 1e-15, where);
      assertEquals(elbow(q, 1), motion.elbowM().y(), 1e-15, where);
      assertEquals(elbow(q, 2), motion.elbowM().z(), 1e-15, where);
      Joints before = Joints.of(last);
      Joints after = Joints.of(next);
      double vx = (elbow(after, 0) - elbow(before, 0)) / (2 * stepS);
      double vz = (elbow(after, 2) - elbow(before, 2)) / (2 * stepS);
      assertEquals(vx, motion.elbowSpeedMPerS().x(), 1e-8, where);
      assertEquals(vz, motion.elbowSpeedMPerS().z(), 1e-8, where);
    }
  }
}
