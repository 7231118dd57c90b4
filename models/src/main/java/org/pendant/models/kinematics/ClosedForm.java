package org.pendant.models.kinematics;

import org.pendant.models.arm.DhLengths;
import org.pendant.models.pose.Transforms;

/**
 * The closed-form inverse of {@link ForwardKinematics}, one method a decision: which side the
 * shoulder is on (joint 1), which way the wrist is turned (joints 5 and 6), and which way the elbow
 * bends (joints 2 to 4). Two ways each make the eight solutions; the other way of a wrist or an
 * elbow follows from the first without another arc tangent.
 *
 * <p>Derivation from the geometry; the same three decisions are described by K. P. Hawkins,
 * "Analytic inverse kinematics for the Universal Robots UR-5/UR-10 arms" (2013). Angles come from
 * {@code atan2} of quantities that stay well scaled, never from an arc sine or cosine alone. Where
 * the pose is out of reach, the joint goes as near as it can; {@link #reaches} tells.
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

  /** Sine of joint 5 below which rounding turns wrist 3 by more than rounding. */
  private static final double WRIST_NEARLY_SINGULAR_SINE = 1e-5;

  /** Turn of the flange (rad), a hundredth of the tightest error allowed, that may be spent. */
  private static final double SPARE_TURN = 1e-12;

  /** A distance (m) or the sine of an angle that counts as zero when a direction is taken of it. */
  private static final double NO_DIRECTION = 1e-12;

  /** How far from 1 the square sum of a sine and a cosine may be that a check relies on. */
  private static final double UNIT_ERROR = 1e-11;

  private final DhLengths dh;
  private final ForwardKinematics forward;
  private final double[] reached = new double[Transforms.SIZE];

  private double[] target;
  private double centreX;
  private double centreY;
  private double centreZ;
  private double shoulderRoot;
  private double c1;
  private double s1;
  private double u;
  private double v;
  private double squared;
  private double c3;
  private double s3;
  private double direction;
  private double lead;
  private double c2;
  private double s2;
  private double q234;
  private double c234;
  private double s234;
  private double c5;
  private double s5;
  private double c6;
  private double s6;

  double q1;
  double q2;
  double q3;
  double q4;
  double q5;
  double q6;

  /** The wrist is nearer to the base axis than its offset. */
  boolean tooClose;

  /** The wrist is further from the shoulder than the arm is long, for the last elbow. */
  boolean tooFar;

  /** The wrist is nearer to the shoulder than the folded arm comes, for the last elbow. */
  boolean tooFolded;

  /** Joint 5 is 0 or pi, so wrist 3 was free. */
  boolean wristFree;

  private boolean shoulderFree;

  ClosedForm(DhLengths dh) {
    this.dh = dh;
    forward = new ForwardKinematics(dh);
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
    double outwards = sign * shoulderRoot;
    double cosine = centreX * outwards - centreY * dh.d4();
    double sine = centreY * outwards + centreX * dh.d4();
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

  /** Joints 5 and 6 and the sum of joints 2 to 4, with the sine of joint 5 positive. */
  void wrist(double nearQ6) {
    double xw = s1 * target[0] - c1 * target[3];
    double yw = s1 * target[1] - c1 * target[4];
    c5 = s1 * target[2] - c1 * target[5];
    s5 = Math.sqrt(xw * xw + yw * yw);
    q5 = Math.atan2(s5, c5);
    wristFree = s5 < WRIST_SINGULAR_SINE;
    if (wristFree) {
      q6 = nearQ6;
      c6 = Math.cos(nearQ6);
      s6 = Math.sin(nearQ6);
    } else {
      c6 = xw / s5;
      s6 = -yw / s5;
      q6 = Math.atan2(s6, c6);
    }
    // s6 x6 + c6 y6 is the direction (-s234, c234) in the plane whatever joint 5 is
    double dirX = s6 * target[0] + c6 * target[1];
    double dirY = s6 * target[3] + c6 * target[4];
    s234 = -(c1 * dirX + s1 * dirY);
    c234 = s6 * target[6] + c6 * target[7];
    q234 = Math.atan2(s234, c234);
    turnWithinReach();
  }

  /** The wrist turned the other way: half a turn more before and after joint 5. */
  void otherWrist() {
    q5 = -q5;
    s5 = -s5;
    q6 = opposite(q6);
    c6 = -c6;
    s6 = -s6;
    q234 = opposite(q234);
    c234 = -c234;
    s234 = -s234;
    turnWithinReach();
  }

  private static double opposite(double angle) {
    return angle > 0 ? angle - Math.PI : angle + Math.PI;
  }

  /**
   * At the wrist singularity, turns wrist 3 as little as needed for the arm to reach. The axes of
   * joints 4 and 6 are then parallel, d5 apart: turning joint 6 swings wrist 1 on a circle about
   * the wrist centre, which may lead out of the arm's reach. The nearest place within is where that
   * circle meets the one of the stretched or the folded arm.
   *
   * <p>Next to the singularity joint 6 is known only up to rounding divided by the sine of joint 5.
   * That much it may turn, too, or a stretched arm would be found to be too short.
   */
  private void turnWithinReach() {
    double sine = Math.abs(s5);
    if (sine >= WRIST_NEARLY_SINGULAR_SINE) {
      return;
    }
    double outwards = c1 * centreX + s1 * centreY;
    double distance = Math.sqrt(outwards * outwards + centreZ * centreZ);
    double square = outwards * outwards + centreZ * centreZ + dh.d5() * dh.d5();
    double reach = square - 2 * dh.d5() * (outwards * s234 - centreZ * c234);
    double stretched = dh.a2() + dh.a3();
    double folded = dh.a2() - dh.a3();
    double bound = Math.max(folded * folded, Math.min(stretched * stretched, reach));
    if (bound == reach || distance * Math.abs(dh.d5()) < NO_DIRECTION) {
      return;
    }
    double cosine = (square - bound) / (2 * dh.d5() * distance);
    double apart = Math.acos(Math.max(-1, Math.min(1, cosine)));
    double middle = Math.atan2(centreZ, outwards) + 0.5 * Math.PI;
    double one = Math.IEEEremainder(middle + apart - q234, 2 * Math.PI);
    double other = Math.IEEEremainder(middle - apart - q234, 2 * Math.PI);
    double turn = Math.abs(one) <= Math.abs(other) ? one : other;
    if (!wristFree && sine * Math.abs(turn) > SPARE_TURN) {
      return;
    }
    q234 += turn;
    s234 = Math.sin(q234);
    c234 = Math.cos(q234);
    q6 -= Math.signum(c5) * turn;
    c6 = Math.cos(q6);
    s6 = Math.sin(q6);
  }

  /** Joints 2 to 4, with the sine of joint 3 positive. */
  void elbow(double nearQ2) {
    u = c1 * centreX + s1 * centreY - dh.d5() * s234;
    v = centreZ + dh.d5() * c234;
    squared = u * u + v * v;
    double cosine = (squared - dh.a2() * dh.a2() - dh.a3() * dh.a3()) / (2 * dh.a2() * dh.a3());
    tooFar = cosine > 1;
    tooFolded = cosine < -1;
    c3 = Math.max(-1, Math.min(1, cosine));
    s3 = Math.sqrt((1 - c3) * (1 + c3));
    q3 = Math.atan2(s3, c3);
    shoulderFree = squared < NO_DIRECTION * NO_DIRECTION;
    // a2 + a3 at the angle q3 is a vector that joint 2 turns onto (u, v)
    direction = shoulderFree ? nearQ2 : Math.atan2(v, u);
    lead = shoulderFree ? 0 : Math.atan2(dh.a3() * s3, dh.a2() + dh.a3() * c3);
    q2 = direction - lead;
    q4 = q234 - q2 - q3;
  }

  /** The elbow bent the other way. */
  void otherElbow() {
    s3 = -s3;
    q3 = -q3;
    lead = -lead;
    q2 = direction - lead;
    q4 = q234 - q2 - q3;
  }

  /** True if joint 1 is more than a quarter turn apart in both. */
  boolean shouldersFarApart() {
    return shoulderRoot > Math.abs(dh.d4());
  }

  /** True if both shoulders give the same. */
  boolean oneShoulder() {
    return shoulderRoot == 0;
  }

  /** True if both elbows give the same. */
  boolean oneElbow() {
    return s3 == 0;
  }

  /** Writes the six joint positions. */
  void copyTo(double[] q) {
    q[0] = q1;
    q[1] = q2;
    q[2] = q3;
    q[3] = q4;
    q[4] = q5;
    q[5] = q6;
  }

  /**
   * True if the joints reach the target within an error in m and rad (1e-10 or more): the forward
   * kinematics of the sines and cosines whose arc tangents the joints are, which spares taking them
   * again.
   */
  boolean reaches(double tolerance) {
    if (!isUnit(c234, s234) || !isUnit(c5, s5)) {
      return false; // the target's matrix is none of a rotation
    }
    double along = dh.a2() + dh.a3() * c3;
    double across = dh.a3() * s3;
    if (shoulderFree) {
      c2 = Math.cos(q2);
      s2 = Math.sin(q2);
    } else {
      double scale = 1 / Math.sqrt(squared * (along * along + across * across));
      c2 = scale * (along * u + across * v);
      s2 = scale * (along * v - across * u);
    }
    forward.flange(
        c1,
        s1,
        c2 * along - s2 * across + dh.d5() * s234,
        dh.d1() + s2 * along + c2 * across - dh.d5() * c234,
        c234,
        s234,
        c5,
        s5,
        c6,
        s6,
        reached);
    return PoseError.within(reached, target, tolerance);
  }

  /**
   * Frames of the links (see {@link ForwardKinematics#frames}) at the joints that {@link #reaches}
   * has just been asked about.
   */
  void frames(double[][] frames) {
    double c23 = c2 * c3 - s2 * s3;
    double s23 = s2 * c3 + c2 * s3;
    forward.frames(c1, s1, c2, s2, c23, s23, c234, s234, c5, s5, c6, s6, frames);
  }

  private static boolean isUnit(double cosine, double sine) {
    return Math.abs(cosine * cosine + sine * sine - 1) <= UNIT_ERROR;
  }
}
