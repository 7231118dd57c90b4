package org.pendant.cell;

/**
 * Convex shape: a box, or a round bar with flat or round ends, around its own middle and along its
 * own z. A ball is a bar of no length.
 *
 * <p>Its core is the shape without its outermost layer. Where shapes touch their cores are apart,
 * and the shortest way between these tells the direction of the contact.
 */
final class ConvexShape {
  private static final double MAX_MARGIN_M = 0.002;

  /** Of the shortest half of a side. */
  private static final double MARGIN_SHARE = 0.25;

  /** Whether its surface is flat all around. */
  final boolean box;

  /** Whether it has a flat end, or is flat all around. */
  final boolean flat;

  /** Half of the length of its sides; of a round one along z alone, m. */
  final double halfX;

  final double halfY;
  final double halfZ;

  /** 0 for a box, m. */
  final double radiusM;

  private final double marginM;

  private ConvexShape(boolean flat, double halfX, double halfY, double halfZ, double radiusM) {
    box = radiusM == 0;
    this.flat = flat;
    this.halfX = halfX;
    this.halfY = halfY;
    this.halfZ = halfZ;
    this.radiusM = radiusM;
    double shortest =
        box ? Math.min(halfX, Math.min(halfY, halfZ)) : flat ? Math.min(halfZ, radiusM) : radiusM;
    marginM = flat ? Math.min(MAX_MARGIN_M, MARGIN_SHARE * shortest) : radiusM;
  }

  /** What is reckoned of a shape; null for one made of faces, or endless. */
  static ConvexShape of(BodyShape shape) {
    return switch (shape) {
      case BodyShape.Box(double x, double y, double z) ->
          new ConvexShape(true, x / 2, y / 2, z / 2, 0);
      case BodyShape.Cylinder(double radius, double length) ->
          new ConvexShape(true, 0, 0, length / 2, radius);
      case BodyShape.Capsule(double radius, double length) ->
          new ConvexShape(false, 0, 0, length / 2, radius);
      case BodyShape.Sphere(double radius) -> new ConvexShape(false, 0, 0, 0, radius);
      case BodyShape.HalfSpace _, BodyShape.Faces _, BodyShape.Hull _, BodyShape.Compound _ -> null;
    };
  }

  /**
   * How far it reaches from its middle along a direction, m.
   *
   * @param pose12 where it is
   */
  double reach(double[] pose12, double x, double y, double z) {
    double along = Math.abs(pose12[2] * x + pose12[5] * y + pose12[8] * z);
    if (box) {
      return halfX * Math.abs(pose12[0] * x + pose12[3] * y + pose12[6] * z)
          + halfY * Math.abs(pose12[1] * x + pose12[4] * y + pose12[7] * z)
          + halfZ * along;
    }
    return flat
        ? halfZ * along + radiusM * Math.sqrt(Math.max(0, 1 - along * along))
        : halfZ * along + radiusM;
  }

  /** Puts a place to the nearest one in its core. */
  void toCore(double[] pose12, double[] place3) {
    double dx = place3[0] - pose12[9];
    double dy = place3[1] - pose12[10];
    double dz = place3[2] - pose12[11];
    double x = pose12[0] * dx + pose12[3] * dy + pose12[6] * dz;
    double y = pose12[1] * dx + pose12[4] * dy + pose12[7] * dz;
    double z = pose12[2] * dx + pose12[5] * dy + pose12[8] * dz;
    if (box) {
      x = clamp(x, halfX - marginM);
      y = clamp(y, halfY - marginM);
      z = clamp(z, halfZ - marginM);
    } else {
      double most = radiusM - marginM;
      double away = Math.sqrt(x * x + y * y);
      double share = away > most ? most / away : 1;
      x *= share;
      y *= share;
      z = clamp(z, flat ? halfZ - marginM : halfZ);
    }
    for (int row = 0; row < 3; row++) {
      place3[row] =
          pose12[9 + row] + pose12[3 * row] * x + pose12[3 * row + 1] * y + pose12[3 * row + 2] * z;
    }
  }

  private static double clamp(double x, double most) {
    return Math.max(-most, Math.min(most, x));
  }
}
