package org.pendant.controller.freedrive;

import java.util.function.Supplier;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/**
 * Sensed push that only an external sensor feels: the drives give way as if it acted on the flange.
 * (B. Siciliano et al., "Robotics: Modelling, Planning and Control", equation 3.111.)
 */
final class SensedPush {
  private final Jacobian jacobian;
  private final Supplier<Wrench> felt;
  private final double[] matrix = new double[Jacobian.SIZE];

  /**
   * A push on an arm.
   *
   * @param felt at the flange's origin, along the axes of the base
   */
  SensedPush(ArmDescription arm, Supplier<Wrench> felt) {
    jacobian = new Jacobian(arm);
    this.felt = felt;
  }

  /** Adds the torques that the push has at the joints, Nm. */
  void add(double[] q, double[] torqueNm) {
    Wrench w = felt.get();
    if (w.equals(Wrench.ZERO)) {
      return;
    }
    jacobian.at(q, Pose.ZERO, matrix);
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      torqueNm[joint] +=
          at(0, joint) * w.fx()
              + at(1, joint) * w.fy()
              + at(2, joint) * w.fz()
              + at(3, joint) * w.mx()
              + at(4, joint) * w.my()
              + at(5, joint) * w.mz();
    }
  }

  private double at(int row, int joint) {
    return matrix[row * Joints.COUNT + joint];
  }
}
