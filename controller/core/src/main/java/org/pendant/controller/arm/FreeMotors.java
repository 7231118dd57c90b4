package org.pendant.controller.arm;

import java.util.List;
import org.pendant.models.arm.Actuator;
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
  private final double[] weightNm = new double[N];
  private Joints torqueNm = Joints.ZERO;
  private Joints dampingNmSPerRad = Joints.ZERO;
  private FrictionShare friction = FrictionShare.NONE;

  FreeMotors(ArmDescription arm, ArmDynamics model) {
    this.arm = arm;
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
    List<Actuator> actuators = arm.actuators();
    for (int i = 0; i < N; i++) {
      Actuator actuator = actuators.get(i);
      step.driveNm[i] = torqueNm.get(i) + weightNm[i];
      step.slopeNmSPerRad[i] = dampingNmSPerRad.get(i);
      step.limitNm[i] = arm.joints().get(i).maxTorqueNm();
      step.coulombNm[i] = (1 - friction.coulomb().get(i)) * actuator.coulombNm();
      step.viscousNmSPerRad[i] = (1 - friction.viscous().get(i)) * actuator.viscousNmSPerRad();
    }
  }

  @Override
  public void stepped(double remainingS, double stepS, ArmBody body, JointStep step) {
    for (int i = 0; i < N; i++) {
      Actuator actuator = arm.actuators().get(i);
      step.motorNm[i] +=
          friction.coulomb().get(i) * actuator.coulombNm() * Math.signum(body.qd[i])
              + friction.viscous().get(i) * actuator.viscousNmSPerRad() * body.qd[i];
    }
  }

  @Override
  public double targetNm(int joint) {
    return torqueNm.get(joint) + weightNm[joint];
  }

  @Override
  public boolean settled() {
    return true;
  }
}
