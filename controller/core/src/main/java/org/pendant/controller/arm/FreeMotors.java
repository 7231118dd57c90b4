package org.pendant.controller.arm;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.motion.servo.FrictionShare;

/**
 * Motors of a freely guided arm, which carry the weight of arm and declared payload by the
 * controller's model and add the torques of a command; they take over a share of the friction, at
 * rest too, as a drive can that measures the torque after its gear, and resist the speeds.
 */
final class FreeMotors implements Drives {
  private static final int N = Joints.COUNT;

  private final ArmDynamics model;
  private final ArmDescription arm;
  private final JointFriction own;
  private final double[] weightNm = new double[N];
  private final double[] overcomeNm = new double[N];
  private Joints torqueNm = Joints.ZERO;
  private Joints dampingNmSPerRad = Joints.ZERO;
  private FrictionShare friction = FrictionShare.NONE;

  FreeMotors(ArmDescription arm, ArmDynamics model, JointFriction own) {
    this.arm = arm;
    this.own = own;
    this.model = model;
  }

  /** Takes the torques of a frame. */
  void add(ArmCommand.Torque command) {
    torqueNm = command.setpoint().torqueNm();
    dampingNmSPerRad = Joints.ZERO;
    friction = command.setpoint().friction();
  }

  /** Takes torques and resistance of a frame. */
  void guide(ArmCommand.Guide command) {
    torqueNm = command.torqueNm();
    dampingNmSPerRad = command.dampingNmSPerRad();
    friction = FrictionShare.MOST;
  }

  @Override
  public void prepare(double remainingS, double stepS, ArmBody body, JointStep step) {
    model.gravity(body.middleQ, weightNm);
    own.underLoad(weightNm);
    for (int i = 0; i < N; i++) {
      step.driveNm[i] = torqueNm.get(i) + weightNm[i];
      step.slopeNmSPerRad[i] = dampingNmSPerRad.get(i);
      step.limitNm[i] = arm.joints().get(i).maxTorqueNm();
      step.coulombNm[i] = (1 - friction.coulomb().get(i)) * own.dryNm[i];
      step.viscousNmSPerRad[i] = (1 - friction.viscous().get(i)) * own.speedDependentNmSPerRad[i];
    }
  }

  @Override
  public void stepped(double remainingS, double stepS, ArmBody body, JointStep step) {
    for (int i = 0; i < N; i++) {
      overcomeNm[i] =
          friction.coulomb().get(i) * own.dryNm[i] * Math.signum(body.qd[i])
              + friction.viscous().get(i) * own.speedDependentNmSPerRad[i] * body.qd[i];
      step.motorNm[i] += overcomeNm[i];
    }
  }

  @Override
  public void publishTarget(SimulatedSensors sensors) {
    for (int i = 0; i < N; i++) {
      double momentNm = torqueNm.get(i) + weightNm[i];
      double constant = arm.actuators().get(i).torqueConstantNmPerA();
      sensors.targetTorqueNm[i] = momentNm;
      sensors.targetCurrent.setWhole(i, (momentNm + overcomeNm[i]) / constant);
    }
  }

  @Override
  public boolean settled() {
    return true;
  }
}
