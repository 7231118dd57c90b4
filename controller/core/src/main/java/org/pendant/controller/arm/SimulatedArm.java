package org.pendant.controller.arm;

import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.motion.force.MeasuredArm;

/** Simulated arm: takes a command once a frame, and reports what its sensors read then. */
public interface SimulatedArm extends MeasuredArm {

  /** Advances by one frame. */
  void step(ArmCommand command);

  /**
   * Says to the world around where the arm will be at the end of the next step, if it shares that
   * world with other arms: all of them say so before the objects there move.
   */
  void place();

  /** Puts the arm elsewhere, at rest; only a simulation can (manual 15.46). */
  void jumpTo(Joints positionRad);

  /** What the sensors report; the same object always, its numbers change with every step. */
  SimulatedSensors sensors();

  /**
   * Whether an arm with noise rests: since the frame before its readings have changed by their
   * noise alone, and by the slow change of its temperatures. Readings without noise never say so.
   */
  boolean rests();

  /**
   * The load on the flange as its force/torque sensor feels it: weight and inertia of what hangs
   * there, contacts and everything else that pushes, at the flange's origin along the flange's
   * axes.
   */
  default Wrench loadOnFlange() {
    double[] load = new double[Joints.COUNT];
    copyLoadOnFlange(load);
    return new Wrench(load[0], load[1], load[2], load[3], load[4], load[5]);
  }

  /** Writes {@link #loadOnFlange} into six numbers. */
  void copyLoadOnFlange(double[] load6);

  /**
   * What {@code payload} would add to {@link #loadOnFlange} if it hung on the flange in its present
   * motion: its weight and inertia, at the flange's origin along the flange's axes.
   */
  default Wrench weightOf(Payload payload) {
    double[] load = new double[Joints.COUNT];
    copyWeightOf(payload, load);
    return new Wrench(load[0], load[1], load[2], load[3], load[4], load[5]);
  }

  /** Writes {@link #weightOf} into six numbers. */
  void copyWeightOf(Payload payload, double[] load6);

  @Override
  default void copyPositionRad(double[] q) {
    sensors().copyPositionRad(q);
  }

  /** What truly hangs on the flange, whatever the controller has been told. */
  void setLoad(Payload load);

  /**
   * How the base is truly mounted and moved.
   *
   * @param x what a resting arm feels along the x axis of the base: gravity, reversed, and the
   *     acceleration of the base, m/s²
   * @param y along the y axis, m/s²
   * @param z along the z axis, m/s²; 9.82 on the floor
   */
  void setMounting(double x, double y, double z);

  /** Moves the point of the tool that touches things and takes applied forces. */
  void setToolCentre(Pose tcpInFlange);

  /**
   * Must be called after the payload, gravity or base acceleration of the controller's model have
   * changed: a resting arm does not look.
   */
  void modelChanged();

  /** Joint positions as the encoders read them, rad. */
  default Joints positionRad() {
    return sensors().positionRad();
  }

  /** Joint speeds, rad/s. */
  default Joints speedRadPerS() {
    return sensors().speedRadPerS();
  }
}
