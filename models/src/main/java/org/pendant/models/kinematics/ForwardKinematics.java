package org.pendant.models.kinematics;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Transforms;

/**
 * Forward kinematics: from joint positions to the frames of the links, seen from the base frame
 * (manual 16.13).
 *
 * <p>The product of the six Denavit-Hartenberg matrices is written out for this family of arms: the
 * second, third and fourth axes are parallel, so the arm moves in a plane that joint 1 turns about
 * the base's z axis. In that plane, with {@code u} horizontal, {@code v} up and {@code w} along the
 * parallel axes, each link adds one vector. (B. Siciliano et al., "Robotics: Modelling, Planning
 * and Control", chapter 2.8, for the convention.)
 *
 * <p>A calibrated arm has no such plane; for it the matrices are multiplied out.
 *
 * <p>Immutable; transformations are laid out as {@link Transforms} says.
 */
public final class ForwardKinematics {
  private final DhLengths dh;
  private final boolean nominal;
  private final CalibratedChain chain;

  /** Kinematics of an arm, its calibration included. */
  public ForwardKinematics(ArmDescription arm) {
    this(arm.dh(), arm.calibration());
  }

  /** Kinematics of a model's nominal arm with these lengths. */
  ForwardKinematics(DhLengths dh) {
    this(dh, Calibration.NONE);
  }

  private ForwardKinematics(DhLengths dh, Calibration calibration) {
    this.dh = dh;
    nominal = calibration.isNominal();
    chain = new CalibratedChain(dh, calibration.geometry());
  }

  /** Pose of the flange in the base frame. */
  public Pose flangePose(Joints q) {
    double[] transform = new double[Transforms.SIZE];
    flange(q.toArray(), transform);
    return Transforms.toPose(transform);
  }

  /**
   * Pose of the TCP in the base frame.
   *
   * @param tcpInFlange the TCP offset
   */
  public Pose tcpPose(Joints q, Pose tcpInFlange) {
    Pose flange = flangePose(q);
    return tcpInFlange.equals(Pose.ZERO) ? flange : Poses.trans(flange, tcpInFlange);
  }

  /**
   * Transformation of the flange in the base frame.
   *
   * @param q six joint positions, rad
   * @param transform twelve numbers, overwritten
   */
  public void flange(double[] q, double[] transform) {
    if (!nominal) {
      chain.flange(q, transform);
      return;
    }
    double c1 = Math.cos(q[0]);
    double s1 = Math.sin(q[0]);
    double c2 = Math.cos(q[1]);
    double s2 = Math.sin(q[1]);
    double c5 = Math.cos(q[4]);
    double s5 = Math.sin(q[4]);
    double c6 = Math.cos(q[5]);
    double s6 = Math.sin(q[5]);
    double q23 = q[1] + q[2];
    double c23 = Math.cos(q23);
    double s23 = Math.sin(q23);
    double c234 = Math.cos(q23 + q[3]);
    double s234 = Math.sin(q23 + q[3]);
    nominalFlange(c1, s1, c2, s2, c23, s23, c234, s234, c5, s5, c6, s6, transform);
  }

  /**
   * As {@link #flange(double[], double[])}.
   *
   * @param angles cosines and sines of {@code q}
   */
  public void flange(double[] q, JointAngles angles, double[] transform) {
    if (!nominal) {
      chain.flange(q, transform);
      return;
    }
    nominalFlange(
        angles.cos(0),
        angles.sin(0),
        angles.cos(1),
        angles.sin(1),
        angles.cos23(),
        angles.sin23(),
        angles.cos234(),
        angles.sin234(),
        angles.cos(4),
        angles.sin(4),
        angles.cos(5),
        angles.sin(5),
        transform);
  }

  private void nominalFlange(
      double c1,
      double s1,
      double c2,
      double s2,
      double c23,
      double s23,
      double c234,
      double s234,
      double c5,
      double s5,
      double c6,
      double s6,
      double[] transform) {
    double u = dh.a2() * c2 + dh.a3() * c23 + dh.d5() * s234;
    double v = dh.d1() + dh.a2() * s2 + dh.a3() * s23 - dh.d5() * c234;
    flange(c1, s1, u, v, c234, s234, c5, s5, c6, s6, transform);
  }

  /**
   * Transformation of the flange of the nominal arm in the base frame, from sines and cosines.
   *
   * @param u of the origin of frame 5, from the base axis outwards in the plane of the arm, m
   * @param v of the same, height over the base, m
   */
  void flange(
      double c1,
      double s1,
      double u,
      double v,
      double c234,
      double s234,
      double c5,
      double s5,
      double c6,
      double s6,
      double[] transform) {
    axis(c1, s1, c6 * c5 * c234 - s6 * s234, c6 * c5 * s234 + s6 * c234, c6 * s5, transform, 0);
    axis(c1, s1, -s6 * c5 * c234 - c6 * s234, -s6 * c5 * s234 + c6 * c234, -s6 * s5, transform, 1);
    axis(c1, s1, -s5 * c234, -s5 * s234, c5, transform, 2);
    origin(
        c1,
        s1,
        u - dh.d6() * s5 * c234,
        v - dh.d6() * s5 * s234,
        dh.d4() + dh.d6() * c5,
        transform);
  }

  /**
   * Transformations of Denavit-Hartenberg frames 1 to 6 in the base frame; the sixth is the flange.
   * Those of a calibrated arm lie on the axes of its joints, as near to the model's as these allow.
   *
   * @param q six joint positions, rad
   * @param frames six rows of twelve numbers, overwritten
   */
  public void frames(double[] q, double[][] frames) {
    if (!nominal) {
      chain.frames(q, frames);
      return;
    }
    double c1 = Math.cos(q[0]);
    double s1 = Math.sin(q[0]);
    double c2 = Math.cos(q[1]);
    double s2 = Math.sin(q[1]);
    double q23 = q[1] + q[2];
    double c23 = Math.cos(q23);
    double s23 = Math.sin(q23);
    double c234 = Math.cos(q23 + q[3]);
    double s234 = Math.sin(q23 + q[3]);
    double c5 = Math.cos(q[4]);
    double s5 = Math.sin(q[4]);
    double c6 = Math.cos(q[5]);
    double s6 = Math.sin(q[5]);
    frames(c1, s1, c2, s2, c23, s23, c234, s234, c5, s5, c6, s6, frames);
  }

  /**
   * As {@link #frames(double[], double[][])}.
   *
   * @param angles cosines and sines of {@code q}
   */
  public void frames(double[] q, JointAngles angles, double[][] frames) {
    if (!nominal) {
      chain.frames(q, frames);
      return;
    }
    frames(
        angles.cos(0),
        angles.sin(0),
        angles.cos(1),
        angles.sin(1),
        angles.cos23(),
        angles.sin23(),
        angles.cos234(),
        angles.sin234(),
        angles.cos(4),
        angles.sin(4),
        angles.cos(5),
        angles.sin(5),
        frames);
  }

  /** As {@link #frames(double[], double[][])} for the nominal arm, from sines and cosines. */
  void frames(
      double c1,
      double s1,
      double c2,
      double s2,
      double c23,
      double s23,
      double c234,
      double s234,
      double c5,
      double s5,
      double c6,
      double s6,
      double[][] frames) {
    double v = dh.d1();
    axis(c1, s1, 1, 0, 0, frames[0], 0);
    axis(c1, s1, 0, 1, 0, frames[0], 1);
    axis(c1, s1, 0, 0, 1, frames[0], 2);
    origin(c1, s1, 0, v, 0, frames[0]);

    double u = dh.a2() * c2;
    v += dh.a2() * s2;
    axis(c1, s1, c2, s2, 0, frames[1], 0);
    axis(c1, s1, -s2, c2, 0, frames[1], 1);
    axis(c1, s1, 0, 0, 1, frames[1], 2);
    origin(c1, s1, u, v, 0, frames[1]);

    u += dh.a3() * c23;
    v += dh.a3() * s23;
    axis(c1, s1, c23, s23, 0, frames[2], 0);
    axis(c1, s1, -s23, c23, 0, frames[2], 1);
    axis(c1, s1, 0, 0, 1, frames[2], 2);
    origin(c1, s1, u, v, 0, frames[2]);

    axis(c1, s1, c234, s234, 0, frames[3], 0);
    axis(c1, s1, 0, 0, 1, frames[3], 1);
    axis(c1, s1, s234, -c234, 0, frames[3], 2);
    origin(c1, s1, u, v, dh.d4(), frames[3]);

    u += dh.d5() * s234;
    v -= dh.d5() * c234;
    axis(c1, s1, c5 * c234, c5 * s234, s5, frames[4], 0);
    axis(c1, s1, -s234, c234, 0, frames[4], 1); // the fourth z axis, reversed
    axis(c1, s1, -s5 * c234, -s5 * s234, c5, frames[4], 2);
    origin(c1, s1, u, v, dh.d4(), frames[4]);

    flange(c1, s1, u, v, c234, s234, c5, s5, c6, s6, frames[5]);
  }

  /** Writes one column of a rotation, given in the plane of the arm, in base coordinates. */
  private static void axis(
      double c1, double s1, double u, double v, double w, double[] transform, int column) {
    transform[column] = c1 * u + s1 * w;
    transform[3 + column] = s1 * u - c1 * w;
    transform[6 + column] = v;
  }

  private static void origin(
      double c1, double s1, double u, double v, double w, double[] transform) {
    transform[9] = c1 * u + s1 * w;
    transform[10] = s1 * u - c1 * w;
    transform[11] = v;
  }
}
