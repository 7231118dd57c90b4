package org.pendant.controller.arm;

import java.util.Arrays;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.Joints;

/**
 * Motor currents that a target needs. Dry friction passes through standstill as a hyperbolic
 * tangent, which takes long; so that part is worked out for those who ask, not in every frame.
 */
final class TargetCurrent {
  private static final Actuator[] NONE = {};

  /** What turns moments and speeds into currents; none where the currents are known whole. */
  private Actuator[] actuators = NONE;

  /** The friction that grows with the speed, or whole currents, A. */
  private final double[] currentA = new double[Joints.COUNT];

  private final double[] speedRadPerS = new double[Joints.COUNT];

  /** No current. */
  void clear() {
    actuators = NONE;
    Arrays.fill(currentA, 0);
  }

  /** The current of a joint is known as it is, and so are those of the others, A. */
  void setWhole(int joint, double amperes) {
    actuators = NONE;
    currentA[joint] = amperes;
  }

  /**
   * Takes what currents follow from, with the moments that {@link #read} is told.
   *
   * @param drives one for each joint
   * @param targetRadPerS six speeds of the target, rad/s
   * @param speedDependentA friction that grows with them, A
   */
  void set(Actuator[] drives, double[] targetRadPerS, double[] speedDependentA) {
    actuators = drives;
    System.arraycopy(targetRadPerS, 0, speedRadPerS, 0, Joints.COUNT);
    System.arraycopy(speedDependentA, 0, currentA, 0, Joints.COUNT);
  }

  /** Takes over another target. */
  void set(TargetCurrent other) {
    set(other.actuators, other.speedRadPerS, other.currentA);
  }

  /**
   * The currents, A.
   *
   * @param momentNm six moments that the target needs without friction, Nm
   */
  Joints read(double[] momentNm) {
    double[] all = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      all[i] = actuators.length == 0 ? currentA[i] : ofMoment(i, momentNm[i]);
    }
    return Joints.of(all);
  }

  private double ofMoment(int i, double momentNm) {
    Actuator actuator = actuators[i];
    return momentNm / actuator.torqueConstantNmPerA()
        + actuator.friction().dryCurrentA(speedRadPerS[i], momentNm)
        + currentA[i];
  }
}
