package org.pendant.controller.arm;

import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/** A straight move in joint space whose speed is a trapezoid over time. */
record Trapezoid(Joints from, Joints to, double acceleration, double speed) {

  int frames() {
    return (int) Math.ceil(durationS() / FrameTime.FRAME_S);
  }

  ArmCommand.Servo at(int frame) {
    double t = Math.min(durationS(), frame * FrameTime.FRAME_S);
    double left = durationS() - t;
    double rampS = speed / acceleration;
    double lengthRad = to.maxAbsDifference(from);
    if (left == 0) {
      return new ArmCommand.Servo(to, Joints.ZERO, Joints.ZERO);
    }
    if (t < rampS) {
      return along(acceleration * t * t / 2, acceleration * t, acceleration);
    }
    if (left > rampS) {
      return along(speed * (t - rampS / 2), speed, 0);
    }
    return along(lengthRad - acceleration * left * left / 2, acceleration * left, -acceleration);
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
