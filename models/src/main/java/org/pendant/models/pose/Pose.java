package org.pendant.models.pose;

/**
 * A position and an orientation of one frame seen from another, as URScript's {@code p[x, y, z, rx,
 * ry, rz]} (manual 3.2).
 *
 * <p>The orientation is a rotation vector: its direction is the axis, its length the angle,
 * right-handed. Any length is a legal input; results of {@link Poses} have the shortest one.
 *
 * @param x position in m
 * @param y position in m
 * @param z position in m
 * @param rx rotation vector in rad
 * @param ry rotation vector in rad
 * @param rz rotation vector in rad
 */
public record Pose(double x, double y, double z, double rx, double ry, double rz) {
  /** Number of components. */
  public static final int SIZE = 6;

  /** The pose of a frame seen from itself. */
  public static final Pose ZERO = new Pose(0, 0, 0, 0, 0, 0);

  /**
   * Makes a pose of six numbers in the order x, y, z, rx, ry, rz.
   *
   * @throws IllegalArgumentException if there are not exactly six
   */
  public static Pose of(double... components) {
    if (components.length != SIZE) {
      throw new IllegalArgumentException(
          "pose: has " + components.length + " components, must have " + SIZE);
    }
    return new Pose(
        components[0], components[1], components[2], components[3], components[4], components[5]);
  }

  /**
   * Component i: 0 to 2 the position in m, 3 to 5 the rotation vector in rad.
   *
   * @throws IndexOutOfBoundsException if i is not 0 to 5
   */
  public double get(int i) {
    return switch (i) {
      case 0 -> x;
      case 1 -> y;
      case 2 -> z;
      case 3 -> rx;
      case 4 -> ry;
      case 5 -> rz;
      default -> throw outside(i);
    };
  }

  /**
   * This pose with component i replaced by v.
   *
   * @throws IndexOutOfBoundsException if i is not 0 to 5
   */
  public Pose with(int i, double v) {
    return switch (i) {
      case 0 -> new Pose(v, y, z, rx, ry, rz);
      case 1 -> new Pose(x, v, z, rx, ry, rz);
      case 2 -> new Pose(x, y, v, rx, ry, rz);
      case 3 -> new Pose(x, y, z, v, ry, rz);
      case 4 -> new Pose(x, y, z, rx, v, rz);
      case 5 -> new Pose(x, y, z, rx, ry, v);
      default -> throw outside(i);
    };
  }

  /** The six components, in a new array. */
  public double[] toArray() {
    return new double[] {x, y, z, rx, ry, rz};
  }

  private static IndexOutOfBoundsException outside(int i) {
    return new IndexOutOfBoundsException("pose: index is " + i + ", must be 0 to 5");
  }
}
