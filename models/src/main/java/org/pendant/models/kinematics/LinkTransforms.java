package org.pendant.models.kinematics;

import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.DhParameters;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.LinkFrame;
import org.pendant.models.arm.LinkFrames;
import org.pendant.models.arm.LinkGeometry;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;

/**
 * Transformations of the six links: what stands behind each joint's turn, {@code flange = Rz(q_1)
 * L_1 Rz(q_2) L_2 ... Rz(q_6) L_6}.
 *
 * <p>Where a link's frame sits on the axis of the next joint, and how it is turned about it, is
 * arbitrary; calibrations put some of them kilometres away. {@link #of} takes each as near to that
 * of the model as the axis allows: the arm is the same, link frames are where the links are, and
 * rounding is that of an arm of ordinary size.
 */
final class LinkTransforms {
  /** The nominal angle between the axes before and after each link, in quarter turns. */
  private static final int[] QUARTERS = {1, 0, 0, 1, -1, 0};

  /** An axis further than this from the model's, by cosine, is that of no such arm. */
  private static final double MIN_COSINE = 0.5;

  private LinkTransforms() {}

  /** Six transformations of an arm, each frame as near to the model's as its axis allows. */
  static double[][] of(DhLengths dh, LinkGeometry geometry) {
    return ofModel(
        dh,
        switch (geometry) {
          case DhDeltas deltas -> ofDeltas(dh, deltas);
          case LinkFrames frames -> ofFrames(frames);
        });
  }

  private static double[][] ofDeltas(DhLengths dh, DhDeltas deltas) {
    DhParameters sums = deltas.on(dh);
    double[][] links = new double[Joints.COUNT][];
    for (int i = 0; i < Joints.COUNT; i++) {
      // quarter turns are put in by hand: the cosine of a rounded pi/2 is not zero
      double cosine = Math.cos(deltas.alphaRad().get(i));
      double sine = Math.sin(deltas.alphaRad().get(i));
      double cosAlpha = QUARTERS[i] == 0 ? cosine : -QUARTERS[i] * sine;
      double sinAlpha = QUARTERS[i] == 0 ? sine : QUARTERS[i] * cosine;
      double c = Math.cos(deltas.thetaRad().get(i));
      double s = Math.sin(deltas.thetaRad().get(i));
      double a = sums.aM().get(i);
      links[i] =
          new double[] {
            c,
            -s * cosAlpha,
            s * sinAlpha,
            s,
            c * cosAlpha,
            -c * sinAlpha,
            0,
            sinAlpha,
            cosAlpha,
            a * c,
            a * s,
            sums.dM().get(i)
          };
    }
    return links;
  }

  /** The first frame turns with the first joint, so it joins the second one behind it. */
  private static double[][] ofFrames(LinkFrames geometry) {
    double[][] frames = frames(geometry);
    double[][] links = new double[Joints.COUNT][Transforms.SIZE];
    Transforms.multiply(frames[0], frames[1], links[0]);
    for (int i = 1; i < Joints.COUNT - 1; i++) {
      links[i] = frames[i + 1];
    }
    slide(0, 0, links[Joints.COUNT - 1]);
    return links;
  }

  /** Transformations of the frames, what stands before each joint's turn. */
  static double[][] frames(LinkFrames geometry) {
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    for (int i = 0; i < Joints.COUNT; i++) {
      LinkFrame frame = geometry.frames().get(i);
      Rotations.rpyToMatrix(frame.rollRad(), frame.pitchRad(), frame.yawRad(), frames[i]);
      frames[i][9] = frame.xM();
      frames[i][10] = frame.yM();
      frames[i][11] = frame.zM();
    }
    return frames;
  }

  /** Moves each frame along and about the axis of the joint that follows, but not the flange. */
  private static double[][] ofModel(DhLengths dh, double[][] links) {
    double[][] nominal = ofDeltas(dh, DhDeltas.NONE);
    double[] back = new double[Transforms.SIZE];
    double[] moved = new double[Transforms.SIZE];
    double[] apart = new double[Transforms.SIZE];
    double[] change = new double[Transforms.SIZE];
    for (int i = 0; i < Joints.COUNT - 1; i++) {
      Transforms.invert(nominal[i], back);
      Transforms.multiply(back, links[i], apart);
      if (apart[8] < MIN_COSINE) {
        continue;
      }
      double turn = -Math.atan2(apart[3] - apart[1], apart[0] + apart[4]);
      slide(turn, -apart[11] / apart[8], change);
      Transforms.multiply(links[i], change, moved);
      System.arraycopy(moved, 0, links[i], 0, Transforms.SIZE);
      Transforms.invert(change, back);
      Transforms.multiply(back, links[i + 1], moved);
      System.arraycopy(moved, 0, links[i + 1], 0, Transforms.SIZE);
    }
    return links;
  }

  /** {@code Rz(turn) Tz(z)}. */
  static void slide(double turn, double z, double[] transform) {
    double c = Math.cos(turn);
    double s = Math.sin(turn);
    double[] slide = {c, -s, 0, s, c, 0, 0, 0, 1, 0, 0, z};
    System.arraycopy(slide, 0, transform, 0, Transforms.SIZE);
  }
}
