package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Transforms;

class ForwardKinematicsTest {
  private final ForwardKinematics forward = new ForwardKinematics(Arms.UR5E);

  @Test
  void ur5eStretchedOutHasItsFlangeWherePublished() {
    Pose flange = forward.flangePose(Joints.ZERO);
    assertEquals(-0.8172, flange.x(), 1e-12);
    assertEquals(-0.2329, flange.y(), 1e-12);
    assertEquals(0.0628, flange.z(), 1e-12);
    assertEquals(Math.PI / 2, flange.rx(), 1e-12);
    assertEquals(0, flange.ry(), 1e-12);
    assertEquals(0, flange.rz(), 1e-12);
  }

  @Test
  void framesAreTheProductsOfDenavitHartenbergMatrices() {
    Random random = new Random(41);
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    double[] flange = new double[Transforms.SIZE];
    for (int n = 0; n < 1000; n++) {
      Joints q = Arms.joints(random);
      forward.frames(q.toArray(), frames);
      forward.flange(q.toArray(), flange);
      assertArrayEquals(frames[5], flange);
      for (int i = 0; i < Joints.COUNT; i++) {
        SimpleMatrix expected = Arms.chain(Arms.UR5E.dh(), q, i + 1);
        int frame = i + 1;
        assertArrayEquals(
            transform(expected), frames[i], 5e-15, () -> "frame " + frame + " at " + q);
      }
    }
  }

  @Test
  void anglesThatAreKnownGiveTheSameFlange() {
    Random random = new Random(43);
    JointAngles angles = new JointAngles();
    double[] expected = new double[Transforms.SIZE];
    double[] flange = new double[Transforms.SIZE];
    for (int n = 0; n < 100; n++) {
      double[] q = Arms.joints(random).toArray();
      angles.at(q);
      forward.flange(q, expected);
      forward.flange(q, angles, flange);
      assertArrayEquals(expected, flange, 5e-15);
    }
  }

  @Test
  void tcpPoseIsTheFlangeMovedByTheOffset() {
    Random random = new Random(42);
    for (int n = 0; n < 1000; n++) {
      Joints q = Arms.joints(random);
      Pose offset = Arms.tcp(random);
      assertEquals(
          Poses.trans(forward.flangePose(q), offset), forward.tcpPose(q, offset), q::toString);
      assertEquals(forward.flangePose(q), forward.tcpPose(q, Pose.ZERO));
    }
  }

  private static double[] transform(SimpleMatrix m) {
    double[] transform = new double[Transforms.SIZE];
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        transform[3 * row + column] = m.get(row, column);
      }
      transform[9 + row] = m.get(row, 3);
    }
    return transform;
  }
}
