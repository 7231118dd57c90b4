package org.pendant.controller.arm;

import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/**
 * A straight move in joint space whose speed is a trapezoid over time; its accelerations are means
 * of frames, as those of targets are.
 */
record Trapezoid(Joints from, Joints to, double acceleration, double speed) {

  int frames() {
    return (int) Math.ceil(durationS() / FrameTime.FRAME_S);
  }

  ArmCommand.Servo at(int frame) {
    double t = timeS(frame);
    double left = durationS() - t;
    double rampS = speed / acceleration;
    double lengthRad = to.maxAbsDifference(from);
    double sd = speedAt(frame);
    double sdd = (sd - speedAt(frame - 1)) / FrameTime.FRAME_S;
    if (left == 0) {
      return new ArmCommand.Servo(
          to, Joints.ZERO, along(lengthRad, 0, sdd).accelerationRadPerS2().joints());
    }
    if (t < rampS) {
      return along(acceleration * t * t / 2, sd, sdd);
    }
    if (left > rampS) {
      return along(speed * (t - rampS / 2), sd, sdd);
    }
    return along(lengthRad - acceleration * left * left / 2, sd, sdd);
  }

  private double timeS(int frame) {
    return Math.clamp(frame * FrameTime.FRAME_S, 0, durationS());
  }

  private double speedAt(int frame) {
    double t = timeS(frame);
    return Math.min(speed, acceleration * Math.min(t, durationS() - t));
  }

  private double durationS() {
    return to.maxAbsDifference(from) / speed + speed / acceleration;
  }

  private ArmCommand.Servo along(double s, double sd, double sdd) {
    double[] q = new double[Joints.COUNT];
    double[] qd = new double[Joints.COUNT];
    double[] qdd = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      double share = (to.get(i) - from.get(i)) / to.maxAbsDifference(from);
      q[i] = from.get(i) + share * s;
      qd[i] = share * sd;
      qdd[i] = share * sdd;
    }
    return new ArmCommand.Servo(Joints.of(q), Joints.of(qd), Joints.of(qdd));
  }
}
