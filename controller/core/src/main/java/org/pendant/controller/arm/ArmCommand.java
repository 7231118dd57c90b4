package org.pendant.controller.arm;

import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.motion.servo.FrictionShare;
import org.pendant.motion.servo.TorqueSetpoint;

/** Arm command: what the controller asks of the arm in one frame. */
public sealed interface ArmCommand {

  /** Motors off, brakes on. */
  BrakesOn BRAKES_ON = new BrakesOn();

  /** Motors off, brakes on: a moving arm is stopped by its brakes, beside any path. */
  record BrakesOn() implements ArmCommand {}

  /**
   * The joint servos follow a target. Whoever gives one in each frame changes the same object, so
   * that nothing is allocated: an arm takes over what it needs longer.
   */
  final class Servo implements ArmCommand {
    private final JointNumbers positionRad = new JointNumbers();
    private final JointNumbers speedRadPerS = new JointNumbers();
    private final JointNumbers accelerationRadPerS2 = new JointNumbers();

    /** At rest with all joints at 0. */
    public Servo() {}

    /** A target; the parameters are those of the methods. */
    public Servo(Joints positionRad, Joints speedRadPerS, Joints accelerationRadPerS2) {
      this.positionRad.set(positionRad);
      this.speedRadPerS.set(speedRadPerS);
      this.accelerationRadPerS2.set(accelerationRadPerS2);
    }

    /** Where the joints should be at the end of the frame, rad. */
    public JointNumbers positionRad() {
      return positionRad;
    }

    /** How fast they should turn then, rad/s. */
    public JointNumbers speedRadPerS() {
      return speedRadPerS;
    }

    /** How fast their speeds should change then, rad/s². */
    public JointNumbers accelerationRadPerS2() {
      return accelerationRadPerS2;
    }

    /** Takes over another target as it is now. */
    void set(Servo other) {
      positionRad.set(other.positionRad);
      speedRadPerS.set(other.speedRadPerS);
      accelerationRadPerS2.set(other.accelerationRadPerS2);
    }

    /** Whether another target is the same now. */
    boolean same(Servo other) {
      return positionRad.same(other.positionRad)
          && speedRadPerS.same(other.speedRadPerS)
          && accelerationRadPerS2.same(other.accelerationRadPerS2);
    }
  }

  /**
   * The motors hold the arm's own weight and that of the declared payload, and add torques; nothing
   * holds the position.
   *
   * @param setpoint the torques, and how much of their friction the motors overcome
   */
  record Torque(TorqueSetpoint setpoint) implements ArmCommand {
    /** Torques of {@code torqueNm} at each joint, Nm, with a share of the friction overcome. */
    public Torque(Joints torqueNm, FrictionShare friction) {
      this(new TorqueSetpoint(torqueNm, friction));
    }
  }

  /**
   * The arm is guided by hand: the motors hold the arm's own weight and that of the declared
   * payload, overcome most of the friction, add torques, and resist the joint speeds. The
   * resistance acts on the speeds at the end of the frame, so any is stable.
   *
   * @param torqueNm added at each joint, Nm
   * @param dampingNmSPerRad by how much each motor lowers its torque for each rad/s, Nm s/rad, at
   *     least 0
   */
  record Guide(Joints torqueNm, Joints dampingNmSPerRad) implements ArmCommand {}
}
