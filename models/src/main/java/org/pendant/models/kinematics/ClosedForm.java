package org.pendant.models.kinematics;

import org.pendant.models.arm.DhLengths;

/**
 * The closed-form inverse of {@link ForwardKinematics}, one method a decision: which side the
 * shoulder is on (joint 1), which way the wrist is turned (joints 5 and 6), and which way the elbow
 * bends (joints 2 to 4). Each method takes a sign and fills in its joints; two signs each make the
 * eight solutions.
 *
 * <p>Derivation from the geometry; the same three decisions are described by K. P. Hawkins,
 * "Analytic inverse kinematics for the Universal Robots UR-5/UR-10 arms" (2013). Angles come from
 * {@code atan2} of quantities that stay well scaled, never from an arc sine or cosine alone. Where
 * the pose is out of reach, the joint goes as near as it can; whoever uses the result checks it
 * with the forward kinematics.
 *
 * <p>Coordinates {@code u, v, w} are those of the plane of the arm, as in {@link
 * ForwardKinematics}.
 */
final class ClosedForm {
  /**
   * Sine of joint 5 below which wrist 3 is free: taking joint 5 for 0 or pi then turns the flange
   * by less than a tenth of the tightest error allowed (1e-10 rad).
   */
  private static final double WRIST_SINGULAR_SINE = 1e-11;

  /** A distance (m) or the sine of an angle that counts as zero when a direction is taken of it. */
  private static final double NO_DIRECTION = 1e-12;

  private final DhLengths dh;

  private double[] target;
  private double centreX;
  private double centreY;
  private double centreZ;
  private double shoulderRoot;
  private double c1;
  private double s1;
  private double c234;
  private double s234;

  double q1;
  double q2;
  double q3;
  double q4;
  double q5;
  double q6;

  /** The wrist is nearer to the base axis than its offset. */
  boolean tooClose;

  /** The wrist is farther from the shoulder than the arm is long, for the last elbow. */
  boolean tooFar;

  /** The wrist is nearer to the shoulder than the folded arm comes, for the last elbow. */
  boolean tooFolded;

  /** Joint 5 is 0 or pi, so wrist 3 was free. */
  boolean wristFree;

  ClosedForm(DhLengths dh) {
    this.dh = dh;
  }

  /** Starts on a flange transformation, which must not change until the last decision. */
  void aimAt(double[] flange) {
    target = flange;
    centreX = flange[9] - dh.d6() * flange[2];
    centreY = flange[10] - dh.d6() * flange[5];
    centreZ = flange[11] - dh.d6() * flange[8] - dh.d1();
    // the wrist centre lies d4 beside the plane of the arm: s1 x - c1 y = d4
    double root = centreX * centreX + centreY * centreY - dh.d4() * dh.d4();
    tooClose = root < 0;
    shoulderRoot = tooClose ? 0 : Math.sqrt(root);
  }

  /** Joint 1, with the wrist before (+1) or behind (-1) the base axis along u. */
  void shoulder(int sign, double nearQ1) {
    double u = sign * shoulderRoot;
    double cosine = centreX * u - centreY * dh.d4();
    double sine = centreY * u + centreX * dh.d4();
    double scale = Math.sqrt(cosine * cosine + sine * sine);
    if (scale < NO_DIRECTION * NO_DIRECTION) {
      // the wrist centre is on the base axis, which leaves joint 1 free
      q1 = nearQ1;
      c1 = Math.cos(nearQ1);
      s1 = Math.sin(nearQ1);
    } else {
      q1 = Math.atan2(sine, cosine);
      c1 = cosine / scale;
      s1 = sine / scale;
    }
  }

  /** Joints 5 and 6, with the sine of joint 5 positive (+1) or negative (-1). */
  void wrist(int sign, double nearQ6) {
    double c5 = s1 * target[2] - c1 * target[5];
    double xw = s1 * target[0] - c1 * target[3];
    double yw = s1 * target[1] - c1 * target[4];
    double sine = Math.sqrt(xw * xw + yw * yw);
    wristFree = sine < WRIST_SINGULAR_SINE;
    q5 = Math.atan2(sign * sine, c5);
    double c6;
    double s6;
    if (wristFree) {
      q6 = nearQ6;
      c6 = Math.cos(nearQ6);
      s6 = Math.sin(nearQ6);
    } else {
      c6 = sign * xw / sine;
      s6 = -sign * yw / sine;
      q6 = Math.atan2(s6, c6);
    }
    // s6 x6 + c6 y6 is the direction (-s234, c234) in the plane whatever joint 5 is
    double dirX = s6 * target[0] + c6 * target[1];
    double dirY = s6 * target[3] + c6 * target[4];
    s234 = -(c1 * dirX + s1 * dirY);
    c234 = s6 * target[6] + c6 * target[7];
    if (wristFree) {
      turnWithinReach(c5);
    }
  }

  /**
   * At the wrist singularity, turns wrist 3 as little as needed for the arm to reach. The axes of
   * joints 4 and 6 are then parallel, d5 apart: turning joint 6 swings wrist 1 on a circle about
   * the wrist centre, which may lead out of the arm's reach. The nearest place within is where that
   * circle meets the one of the stretched or the folded arm.
   */
  private void turnWithinReach(double c5) {
    double u = c1 * centreX + s1 * centreY;
    double distance = Math.sqrt(u * u + centreZ * centreZ);
    double square = u * u + centreZ * centreZ + dh.d5() * dh.d5();
    double reach = square - 2 * dh.d5() * (u * s234 - centreZ * c234);
    double stretched = dh.a2() + dh.a3();
    double folded = dh.a2() - dh.a3();
    double bound = Math.max(folded * folded, Math.min(stretched * stretched, reach));
    if (bound == reach || distance * Math.abs(dh.d5()) < NO_DIRECTION) {
      return;
    }
    double cosine = (square - bound) / (2 * dh.d5() * distance);
    double apart = Math.acos(Math.max(-1, Math.min(1, cosine)));
    double middle = Math.atan2(centreZ, u) + 0.5 * Math.PI;
    double present = Math.atan2(s234, c234);
    double one = Math.IEEEremainder(middle + apart - present, 2 * Math.PI);
    double other = Math.IEEEremainder(middle - apart - present, 2 * Math.PI);
    double turn = Math.abs(one) <= Math.abs(other) ? one : other;
    s234 = Math.sin(present + turn);
    c234 = Math.cos(present + turn);
    q6 -= Math.signum(c5) * turn;
  }

  /** Joints 2 to 4, with the sine of joint 3 positive (+1) or negative (-1). */
  void elbow(int sign, double nearQ2) {
    double u = c1 * centreX + s1 * centreY - dh.d5() * s234;
    double v = centreZ + dh.d5() * c234;
    double squared = u * u + v * v;
    double c3 = (squared - dh.a2() * dh.a2() - dh.a3() * dh.a3()) / (2 * dh.a2() * dh.a3());
    tooFar = c3 > 1;
    tooFolded = c3 < -1;
    c3 = Math.max(-1, Math.min(1, c3));
    double s3 = sign * Math.sqrt((1 - c3) * (1 + c3));
    q3 = Math.atan2(s3, c3);
    // a2 + a3 at the angle q3 is the vector (along, across) that joint 2 turns onto (u, v)
    double along = dh.a2() + dh.a3() * c3;
    double across = dh.a3() * s3;
    boolean free = squared < NO_DIRECTION * NO_DIRECTION;
    q2 = free ? nearQ2 : Math.atan2(along * v - across * u, along * u + across * v);
    q4 = Math.atan2(s234, c234) - q2 - q3;
  }

  /** True if both shoulder signs give the same. */
  boolean oneShoulder() {
    return shoulderRoot == 0;
  }
}
