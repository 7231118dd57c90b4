package org.pendant.motion.toolpath;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.pose.Pose;
import org.pendant.motion.ToolCurve;

/**
 * Chain builder: joins legs to a chain that can be passed without a sudden turn: where two of them
 * meet in a corner it is rounded, or the tool stops there.
 *
 * <p>A corner with a blend radius is rounded within it. Points within a toolpath need none: there a
 * corner of at most {@value #SHALLOW_RAD} rad is rounded so little that the tool stays within
 * {@value #TOLERANCE_M} m of the point. No corner takes more than half of a leg.
 */
final class Chaining {
  /** How far from a point of a toolpath without a blend radius the tool may pass, m. */
  static final double TOLERANCE_M = 5e-5;

  /** Above this angle a corner of a toolpath without a blend radius is meant to be sharp, rad. */
  static final double SHALLOW_RAD = Math.PI / 6;

  /** What the tool's turning by one rad counts as where speeds and accelerations change, m. */
  private static final double RADIAN_M = 0.25;

  /** The least length of a leg for each rad that the tool turns on it, m. */
  static final double MIN_M_PER_RAD = 0.005;

  /** A change of direction below this is none. */
  private static final double NO_CORNER = 1e-9;

  private static final double NOTHING_M = 1e-12;

  /**
   * The part of the acceleration limit that a curve may take by its bend; the change of speed takes
   * so much that both together do not exceed it.
   */
  private static final double ACROSS = 0.8;

  /** How fast the tool may turn however slow it is, rad/s. */
  private static final double TURNING_RAD_PER_S = 2;

  /** How far the tool may be turned away in a point of a toolpath without a blend radius, rad. */
  private static final double TOLERANCE_RAD = 2e-3;

  private final List<Chain.Piece> pieces = new ArrayList<>();
  private final double[] twist = new double[Pose.SIZE];
  private final double[] other = new double[Pose.SIZE];

  private Chaining() {}

  /** The chain of legs, each beginning where the one before ends; at least one. */
  static Chain of(List<Leg> legs) {
    Chaining chaining = new Chaining();
    double cut = 0;
    for (int i = 0; i < legs.size(); i++) {
      Leg leg = legs.get(i);
      if (i + 1 == legs.size()) {
        chaining.along(leg, cut, leg.length(), false);
        break;
      }
      Leg next = legs.get(i + 1);
      double bend = chaining.bend(leg, next);
      double reach = bend > NO_CORNER ? chaining.reach(leg, next) : 0;
      chaining.along(leg, cut, leg.length() - reach, bend > NO_CORNER && reach == 0);
      if (reach > 0) {
        chaining.round(leg, next, reach);
      }
      cut = reach;
    }
    return new Chain(chaining.pieces);
  }

  /** By how much the direction changes between two legs, for each metre. */
  private double bend(Leg leg, Leg next) {
    leg.curve().rate(leg.length(), twist);
    next.curve().rate(0, other);
    for (int i = 0; i < Pose.SIZE; i++) {
      twist[i] -= other[i];
    }
    return size(twist);
  }

  /** The size of a change, turning counted in metres. */
  private static double size(double[] t) {
    return Math.max(linear(t), RADIAN_M * turning(t));
  }

  private static double linear(double[] t) {
    return Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
  }

  private static double turning(double[] t) {
    return Math.sqrt(t[3] * t[3] + t[4] * t[4] + t[5] * t[5]);
  }

  /** How far from the corner the legs may be left; 0 to stop in it. */
  private double reach(Leg leg, Leg next) {
    double half = 0.5 * Math.min(leg.length(), next.length());
    double radius = leg.pace().radiusM();
    if (radius > 0) {
      return Math.min(radius, half);
    }
    double aside = linear(twist);
    if (!leg.pace().inner() || aside > 2 * Math.sin(0.5 * SHALLOW_RAD)) {
      return 0;
    }
    // a parabola passes its corner at a quarter of reach times the change of direction
    double near = 4 * TOLERANCE_M / aside;
    double level = 4 * TOLERANCE_RAD / turning(twist);
    return Math.min(half, Math.min(near, level));
  }

  private void along(Leg leg, double from, double to, boolean stops) {
    if (to - from > NOTHING_M) {
      add(leg.curve(), from, to - from, leg.pace(), stops, leg.name());
    }
  }

  private void round(Leg leg, Leg next, double reach) {
    ToolCurve corner = new CornerSegment(leg.curve(), leg.length(), next.curve(), reach);
    Leg.Limits a = leg.pace();
    Leg.Limits b = next.pace();
    Leg.Limits both =
        new Leg.Limits(
            Math.min(a.accelerationMPerS2(), b.accelerationMPerS2()),
            Math.min(a.speedMPerS(), b.speedMPerS()),
            0,
            false);
    add(corner, 0, 2 * reach, both, false, leg.name());
  }

  private void add(
      ToolCurve curve, double from, double length, Leg.Limits pace, boolean stops, String name) {
    double bend = 0;
    double turning = 0;
    double back = 0;
    for (int i = 0; i <= 2; i++) {
      curve.bend(from + 0.5 * i * length, twist);
      curve.rate(from + 0.5 * i * length, other);
      bend = Math.max(bend, size(twist));
      turning = Math.max(turning, turning(other));
      back = Math.max(back, alignment());
    }
    boolean straight = bend < NO_CORNER;
    double most = pace.accelerationMPerS2();
    double speed = Math.min(pace.speedMPerS(), turningLimit(pace) / turning);
    double along = Math.min(most, most / RADIAN_M / turning);
    if (!straight) {
      speed = Math.min(speed, Math.sqrt(ACROSS * most / bend));
      along *= Math.sqrt(1 - ACROSS * ACROSS * (1 - back * back)) - ACROSS * back;
    }
    pieces.add(new Chain.Piece(curve, from, length, speed, along, stops, name));
  }

  private static double turningLimit(Leg.Limits pace) {
    return Math.max(TURNING_RAD_PER_S, pace.speedMPerS() / RADIAN_M);
  }

  /** How far the bend of a curve points along it rather than across, 0 to 1. */
  private double alignment() {
    double product = twist[0] * other[0] + twist[1] * other[1] + twist[2] * other[2];
    double sizes = linear(twist) * linear(other);
    return sizes > 0 ? Math.min(1, Math.abs(product) / sizes) : 0;
  }
}
