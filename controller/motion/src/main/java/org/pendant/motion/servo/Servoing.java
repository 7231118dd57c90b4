package org.pendant.motion.servo;

import java.util.OptionalDouble;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.PlanningException;

/**
 * Servo planner: makes the motions of one arm that have no end of their own. A program streams
 * them, so a new one takes over from the one before at its speed; left alone they end by
 * themselves. Belongs to the thread of the frame loop.
 */
public final class Servoing {
  /** How long such a motion continues if nothing ends it, s: longer than any caller waits. */
  static final double ENDLESS_S = 1e9;

  private final ArmDescription arm;
  private final MotionControl motion;
  private final ToolSpeeds toolSpeeds;
  private TorqueSetpoint torque = TorqueSetpoint.ZERO;

  /** For an arm and what moves it. */
  public Servoing(ArmDescription arm, MotionControl motion) {
    this.arm = arm;
    this.motion = motion;
    toolSpeeds = new ToolSpeeds(arm);
  }

  /**
   * Brings the joints to constant speeds, all at the same moment (manual 15.48). Speeds that a
   * joint cannot do are lowered, all in proportion.
   *
   * @param speedRadPerS wanted, rad/s
   * @param accelerationRadPerS2 of the joint whose speed changes most, above 0; also when nothing
   *     follows and the arm comes to rest
   * @param returnS when the program continues, s, at least 0; empty for when the speed is reached
   */
  public MotionPlan speedJ(
      Joints speedRadPerS, double accelerationRadPerS2, OptionalDouble returnS) {
    Joints possible = possible(speedRadPerS);
    return (from, speed) -> new SpeedJ(from, speed, possible, accelerationRadPerS2, returnS);
  }

  private Joints possible(Joints speed) {
    double excess = 1;
    for (int i = 0; i < Joints.COUNT; i++) {
      JointLimits limits = arm.joints().get(i);
      excess = Math.max(excess, Math.abs(speed.get(i)) / limits.maxSpeedRadPerS());
    }
    return excess == 1
        ? speed
        : new Joints(
            speed.q0() / excess,
            speed.q1() / excess,
            speed.q2() / excess,
            speed.q3() / excess,
            speed.q4() / excess,
            speed.q5() / excess);
  }

  /**
   * Brings the TCP to a constant velocity (manual 15.49).
   *
   * @param tcpInFlange the TCP offset
   * @param twistInBase velocity in m/s and angular velocity in rad/s along the axes of the base
   * @param accelerationMPerS2 of the TCP, above 0
   * @param angularAccelerationRadPerS2 of the turning, above 0; the slower of the two decides for
   *     both
   * @param returnS as for {@link #speedJ}
   */
  public MotionPlan speedL(
      Pose tcpInFlange,
      double[] twistInBase,
      double accelerationMPerS2,
      double angularAccelerationRadPerS2,
      OptionalDouble returnS) {
    return (from, speed) ->
        toolSpeeds.motion(
            from,
            speed,
            tcpInFlange,
            twistInBase,
            accelerationMPerS2,
            angularAccelerationRadPerS2,
            returnS);
  }

  /**
   * Lets the joints run after a position (manual 15.44).
   *
   * @param goalRad where they are to be, rad
   * @param timeS how long the program waits, s, at least 0
   * @param lookaheadS how far ahead the present speed is reckoned with, s, above 0
   * @param gain acceleration for each rad that is left, 1/s², above 0
   */
  public MotionPlan servoJ(Joints goalRad, double timeS, double lookaheadS, double gain) {
    return (from, speed) -> new ServoJ(arm.joints(), from, speed, goalRad, timeS, lookaheadS, gain);
  }

  /**
   * Leads the TCP to a pose on an arc that continues its present direction.
   *
   * @param goalInBase where the TCP is to be
   * @param tcpInFlange the TCP offset
   * @param accelerationMPerS2 along the way, above 0
   * @param speedMPerS along the way, above 0
   * @param radiusM how far before the goal the program continues, m, at least 0
   */
  public MotionPlan servoC(
      Pose goalInBase,
      Pose tcpInFlange,
      double accelerationMPerS2,
      double speedMPerS,
      double radiusM) {
    return (from, speed) ->
        ServoC.plan(
            arm, from, speed, goalInBase, tcpInFlange, accelerationMPerS2, speedMPerS, radiusM);
  }

  /**
   * Torques for the frame that comes (manual 15.2).
   *
   * @param torqueNm added to what holds the weight, Nm; the motors give what they can
   * @param friction how much of their friction the motors overcome
   * @throws PlanningException when a thread's motion is under way, or the arm is guided by hand
   */
  public void giveTorque(Joints torqueNm, FrictionShare friction) throws PlanningException {
    motion.giveTorque();
    torque = new TorqueSetpoint(torqueNm, friction);
  }

  /** The torques that were given last. */
  public TorqueSetpoint torque() {
    return torque;
  }
}
