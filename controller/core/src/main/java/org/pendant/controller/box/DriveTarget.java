package org.pendant.controller.box;

import org.pendant.controller.arm.ArmCommand;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.MotionControl;

/**
 * Drive target: what the servos follow: the motion's setpoint or, beside it, the place where a
 * protective stop has left the arm. An arm that was stopped by an obstacle rests where it is
 * instead of pressing on; when the program continues, it returns to its path slowly.
 */
final class DriveTarget {
  /** How fast the arm returns to its path, rad/s. */
  private static final double RETURN_RAD_PER_S = 0.1;

  private Joints besideRad = Joints.ZERO;

  /** Given in each frame, with other numbers. */
  private final ArmCommand.Servo servo = new ArmCommand.Servo();

  /** From now on the arm stays at {@code actualRad} while the motion rests at {@code targetRad}. */
  void stayAt(Joints actualRad, Joints targetRad) {
    double[] beside = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      beside[i] = actualRad.get(i) - targetRad.get(i);
    }
    besideRad = Joints.of(beside);
  }

  /** The motion itself has moved to where the arm is. */
  void forget() {
    besideRad = Joints.ZERO;
  }

  /** Whether the arm is kept beside its path. */
  boolean beside() {
    return !besideRad.equals(Joints.ZERO);
  }

  /** Comes one frame nearer to the path. */
  void stepBack() {
    double largest = besideRad.maxAbsDifference(Joints.ZERO);
    double left = largest - RETURN_RAD_PER_S * FrameTime.FRAME_S;
    besideRad = left > 0 ? scaled(left / largest) : Joints.ZERO;
  }

  private Joints scaled(double factor) {
    double[] scaled = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      scaled[i] = factor * besideRad.get(i);
    }
    return Joints.of(scaled);
  }

  /** Where the joints should be at the end of the frame, rad. */
  Joints positionRad(MotionControl motion) {
    if (!beside()) {
      return motion.positionRad();
    }
    double[] sum = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      sum[i] = motion.positionRad().get(i) + besideRad.get(i);
    }
    return Joints.of(sum);
  }

  /** Takes over where the joints should be at the end of the frame, rad. */
  void readPositionRad(MotionControl motion, JointNumbers target) {
    if (beside()) {
      target.set(positionRad(motion));
    } else {
      motion.readPositionRad(target);
    }
  }

  /** What the servos follow in this frame. */
  ArmCommand servo(MotionControl motion) {
    readPositionRad(motion, servo.positionRad());
    motion.readSpeedRadPerS(servo.speedRadPerS());
    motion.readAccelerationRadPerS2(servo.accelerationRadPerS2());
    return servo;
  }
}
