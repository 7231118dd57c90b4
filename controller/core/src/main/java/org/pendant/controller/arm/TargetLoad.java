package org.pendant.controller.arm;

import java.util.Arrays;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;

/**
 * Load of the target motion on the drives by the controller's model, as the controller publishes
 * it: the moment that links, declared payload and rotors need, and the current for that moment and
 * for the friction of the target speed, which is exactly 0 at standstill.
 */
final class TargetLoad {
  private static final int N = Joints.COUNT;

  /** Without friction, Nm. */
  final double[] momentNm = new double[N];

  /** Friction that grows with the speed, Nm. */
  final double[] speedDependentNm = new double[N];

  /** Accelerations of the target, rad/s². */
  final double[] qdd = new double[N];

  private final ArmDynamics model;
  private final Actuator[] actuators;
  private final double[] q = new double[N];
  private final double[] qd = new double[N];
  private final double[] speedDependentA = new double[N];

  TargetLoad(ArmDescription arm, ArmDynamics model) {
    this.model = model;
    actuators = arm.actuators().toArray(Actuator[]::new);
  }

  /** Takes the target of a frame. */
  void of(ArmCommand.Servo target) {
    target.positionRad().copyTo(q);
    target.speedRadPerS().copyTo(qd);
    target.accelerationRadPerS2().copyTo(qdd);
    model.inverse(q, qd, qdd, momentNm);
    for (int i = 0; i < N; i++) {
      Actuator actuator = actuators[i];
      momentNm[i] += actuator.rotorInertiaKgM2() * qdd[i];
      speedDependentA[i] = actuator.friction().speedDependentA(qd[i]);
      speedDependentNm[i] = actuator.torqueConstantNmPerA() * speedDependentA[i];
    }
  }

  /** Writes what the controller publishes. */
  void publish(SimulatedSensors sensors) {
    System.arraycopy(momentNm, 0, sensors.targetTorqueNm, 0, N);
    sensors.targetCurrent.set(actuators, qd, speedDependentA);
  }

  /** Writes that there is no target. */
  static void publishNone(SimulatedSensors sensors) {
    Arrays.fill(sensors.targetTorqueNm, 0);
    sensors.targetCurrent.clear();
  }
}
