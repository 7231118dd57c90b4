package org.pendant.desktop.scene.mesh;

import java.util.ArrayList;
import java.util.List;

/**
 * Lathe profile: half the outline of a turned part: corners from its axis at the bottom to its axis
 * at the top, the solid on the left of the outline. Corners are rounded.
 */
final class LatheProfile {
  /** Steps of a quarter circle, and of one that is large enough to be looked at. */
  private static final int STEPS = 3;

  private static final int STEPS_OF_LARGE = 8;
  private static final double LARGE_M = 0.006;

  private final List<Corner> corners = new ArrayList<>();

  /**
   * A point of the outline.
   *
   * @param r distance from the axis, m
   * @param z along the axis, m
   * @param nr part of the outward normal away from the axis
   * @param nz part of the outward normal along the axis
   */
  record Point(double r, double z, double nr, double nz) {}

  private record Corner(double r, double z, double roundingM) {}

  /** Continues to a sharp corner, or, first and last, to a point of the axis. */
  LatheProfile to(double r, double z) {
    return to(r, z, 0);
  }

  /** Continues to a corner with this radius of rounding, less where the sides are too short. */
  LatheProfile to(double r, double z, double roundingM) {
    corners.add(new Corner(r, z, roundingM));
    return this;
  }

  /** Points of the outline; a sharp corner is there twice, with the normals of both sides. */
  List<Point> points(Detail detail) {
    List<Point> points = new ArrayList<>();
    int last = corners.size() - 1;
    addEnd(corners.get(0), corners.get(0), corners.get(1), points);
    for (int i = 1; i < last; i++) {
      addCorner(corners.get(i - 1), corners.get(i), corners.get(i + 1), detail, points);
    }
    addEnd(corners.get(last), corners.get(last - 1), corners.get(last), points);
    return points;
  }

  private static void addEnd(Corner at, Corner from, Corner to, List<Point> points) {
    double length = Math.hypot(to.r - from.r, to.z - from.z);
    points.add(new Point(at.r, at.z, (to.z - from.z) / length, (from.r - to.r) / length));
  }

  private static void addCorner(
      Corner before, Corner at, Corner after, Detail detail, List<Point> points) {
    double in = Math.hypot(at.r - before.r, at.z - before.z);
    double out = Math.hypot(after.r - at.r, after.z - at.z);
    double inR = (at.r - before.r) / in;
    double inZ = (at.z - before.z) / in;
    double outR = (after.r - at.r) / out;
    double outZ = (after.z - at.z) / out;
    double turnRad = Math.atan2(inR * outZ - inZ * outR, inR * outR + inZ * outZ);
    double tangent = Math.abs(Math.tan(turnRad / 2));
    double radiusM = Math.min(at.roundingM, 0.49 * Math.min(in, out) / Math.max(tangent, 1e-9));
    double cut = radiusM * tangent;
    double side = Math.signum(turnRad); // 1 where the outline turns around the solid
    double startR = at.r - cut * inR;
    double startZ = at.z - cut * inZ;
    double centreR = startR - side * radiusM * inZ;
    double centreZ = startZ + side * radiusM * inR;
    int most = detail.steps(radiusM > LARGE_M ? STEPS_OF_LARGE : STEPS);
    int steps =
        radiusM == 0 ? 1 : (int) Math.max(1, Math.ceil(most * Math.abs(turnRad) / (Math.PI / 2)));
    for (int i = 0; i <= steps; i++) {
      double angle = turnRad * i / steps;
      double nr = inZ * Math.cos(angle) + inR * Math.sin(angle);
      double nz = -inR * Math.cos(angle) + inZ * Math.sin(angle);
      points.add(new Point(centreR + side * radiusM * nr, centreZ + side * radiusM * nz, nr, nz));
    }
  }
}
