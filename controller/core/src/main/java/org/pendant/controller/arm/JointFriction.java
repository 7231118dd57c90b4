package org.pendant.controller.arm;

import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;

/**
 * Friction of the true joints in one frame: dry friction, and what grows with the speed. The latter
 * is taken in proportion to the speed within a frame, by the secant of its curve at the speed with
 * which the frame begins: it always brakes, and is right to the first order of a frame's change of
 * speed.
 */
final class JointFriction {
  /** Dry friction under the load of the frame, Nm. */
  final double[] dryNm = new double[Joints.COUNT];

  /** The rest over the speed, Nm s/rad. */
  final double[] speedDependentNmSPerRad = new double[Joints.COUNT];

  private final Actuator[] actuators;

  JointFriction(ArmDescription arm) {
    actuators = arm.actuators().toArray(Actuator[]::new);
  }

  /** Takes the loads of the joints, Nm. */
  void underLoad(double[] loadNm) {
    for (int i = 0; i < Joints.COUNT; i++) {
      dryNm[i] = actuators[i].dryNm(loadNm[i]);
    }
  }

  /** Takes the speeds with which a frame begins, rad/s. */
  void beginFrame(double[] speedRadPerS) {
    for (int i = 0; i < Joints.COUNT; i++) {
      speedDependentNmSPerRad[i] = actuators[i].speedDependentNmSPerRad(speedRadPerS[i]);
    }
  }

  /** Friction of a joint at a speed of the frame, Nm; 0 at standstill, where it may hold. */
  double slidingNm(int joint, double speedRadPerS) {
    return dryNm[joint] * Math.signum(speedRadPerS) + speedDependentNmSPerRad[joint] * speedRadPerS;
  }
}
