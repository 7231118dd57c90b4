package org.pendant.cell;

/**
 * Contact feature: what of a shape faces a direction, within a few degrees: a face, an edge or a
 * point. It is seen along the normal of a {@link ContactFrame}, with a height over each place.
 */
final class ContactFeature {
  /** Kinds of features. */
  enum Kind {
    /** The lowest or highest point. */
    POINT,
    /** An edge, or a line on something round. */
    EDGE,
    /** A side of a box. */
    POLYGON,
    /** An end of a cylinder. */
    DISC,
    /** All of a half space. */
    PLANE
  }

  /** A face leans less than that; the cosine. */
  private static final double FACE = 0.98;

  /** An edge leans less than that; the sine. */
  private static final double EDGE = 0.2;

  Kind kind = Kind.POINT;

  /** Points: corners, ends, the middle of a disc. */
  int count;

  final double[] x = new double[4];
  final double[] y = new double[4];

  /** Heights of these, m. */
  final double[] z = new double[4];

  double radiusM;

  /** How steep a face is along both directions. */
  double slopeX;

  double slopeY;

  private ContactFrame frame;
  private double[] pose;

  /**
   * Takes the feature of a shape.
   *
   * @param side 1 for what faces along the normal, -1 for what faces against it
   */
  void set(ConvexShape shape, double[] pose12, ContactFrame seenFrom, double side) {
    frame = seenFrom;
    pose = pose12;
    count = 0;
    if (shape == null) {
      kind = Kind.PLANE;
      add(0, 0, 0);
      face(2);
    } else if (shape.box) {
      setBox(shape, side);
    } else {
      setRound(shape, side);
    }
  }

  /** How high a face, or the line through an edge, is at a place, m. */
  double heightAt(double atX, double atY) {
    return switch (kind) {
      case POINT -> z[0];
      case EDGE -> {
        double alongX = x[1] - x[0];
        double alongY = y[1] - y[0];
        double square = alongX * alongX + alongY * alongY;
        double share = square > 0 ? ((atX - x[0]) * alongX + (atY - y[0]) * alongY) / square : 0.5;
        yield z[0] + Math.max(0, Math.min(1, share)) * (z[1] - z[0]);
      }
      case POLYGON, DISC, PLANE -> z[0] + slopeX * (atX - x[0]) + slopeY * (atY - y[0]);
    };
  }

  private void setBox(ConvexShape shape, double side) {
    double cx = side * alongNormal(0);
    double cy = side * alongNormal(1);
    double cz = side * alongNormal(2);
    double ax = Math.abs(cx);
    double ay = Math.abs(cy);
    double az = Math.abs(cz);
    double x = cx < 0 ? -shape.halfX : shape.halfX;
    double y = cy < 0 ? -shape.halfY : shape.halfY;
    double z = cz < 0 ? -shape.halfZ : shape.halfZ;
    double most = Math.max(ax, Math.max(ay, az));
    double least = Math.min(ax, Math.min(ay, az));
    if (most > FACE) {
      kind = Kind.POLYGON;
      int axis = az == most ? 2 : ay == most ? 1 : 0;
      for (int corner = 0; corner < 4; corner++) {
        double u = corner == 0 || corner == 3 ? 1 : -1;
        double v = corner < 2 ? 1 : -1;
        switch (axis) {
          case 0 -> add(x, u * y, v * z);
          case 1 -> add(u * x, y, v * z);
          default -> add(u * x, v * y, z);
        }
      }
      face(axis);
    } else if (least < EDGE) {
      kind = Kind.EDGE;
      add(x, y, z);
      if (ax == least) {
        add(-x, y, z);
      } else if (ay == least) {
        add(x, -y, z);
      } else {
        add(x, y, -z);
      }
    } else {
      kind = Kind.POINT;
      add(x, y, z);
    }
  }

  private void setRound(ConvexShape shape, double side) {
    double cx = side * alongNormal(0);
    double cy = side * alongNormal(1);
    double cz = side * alongNormal(2);
    double half = cz < 0 ? -shape.halfZ : shape.halfZ;
    double r = shape.radiusM;
    if (!shape.flat) {
      add(r * cx, r * cy, r * cz + half);
      kind = shape.halfZ > 0 && Math.abs(cz) < EDGE ? Kind.EDGE : Kind.POINT;
      if (kind == Kind.EDGE) {
        add(r * cx, r * cy, r * cz - half);
      }
      return;
    }
    if (Math.abs(cz) > FACE) {
      kind = Kind.DISC;
      radiusM = r;
      add(0, 0, half);
      face(2);
      return;
    }
    double across = r / Math.sqrt(cx * cx + cy * cy);
    add(across * cx, across * cy, half);
    kind = Math.abs(cz) < EDGE ? Kind.EDGE : Kind.POINT;
    if (kind == Kind.EDGE) {
      add(across * cx, across * cy, -half);
    }
  }

  private double alongNormal(int axis) {
    return frame.normal[0] * pose[axis]
        + frame.normal[1] * pose[3 + axis]
        + frame.normal[2] * pose[6 + axis];
  }

  /** Takes the slope of a face at right angles to an axis. */
  private void face(int axis) {
    double nx = along(frame.tangent1, axis);
    double ny = along(frame.tangent2, axis);
    double nz = alongNormal(axis);
    slopeX = -nx / nz;
    slopeY = -ny / nz;
  }

  private double along(double[] direction, int axis) {
    return direction[0] * pose[axis]
        + direction[1] * pose[3 + axis]
        + direction[2] * pose[6 + axis];
  }

  /** Adds a point of the shape's own axes. */
  private void add(double ownX, double ownY, double ownZ) {
    double dx = pose[9] - frame.origin[0] + pose[0] * ownX + pose[1] * ownY + pose[2] * ownZ;
    double dy = pose[10] - frame.origin[1] + pose[3] * ownX + pose[4] * ownY + pose[5] * ownZ;
    double dz = pose[11] - frame.origin[2] + pose[6] * ownX + pose[7] * ownY + pose[8] * ownZ;
    x[count] = dot(frame.tangent1, dx, dy, dz);
    y[count] = dot(frame.tangent2, dx, dy, dz);
    z[count] = dot(frame.normal, dx, dy, dz);
    count++;
  }

  private static double dot(double[] direction, double x, double y, double z) {
    return direction[0] * x + direction[1] * y + direction[2] * z;
  }
}
