package org.pendant.controller.freedrive;

/**
 * Free axes: the ones along and about which the tool centre point may be guided; axes of a {@link
 * FreedriveFrame} (manual 15.18).
 *
 * @param x along x
 * @param y along y
 * @param z along z
 * @param rx about an axis through the tool centre point that is parallel to x
 * @param ry about one parallel to y
 * @param rz about one parallel to z
 */
public record FreeAxes(boolean x, boolean y, boolean z, boolean rx, boolean ry, boolean rz) {
  /** How many axes there are. */
  public static final int COUNT = 6;

  /** Any way. */
  public static final FreeAxes ALL = new FreeAxes(true, true, true, true, true, true);

  /** Whether axis 0 to 5, translations first, is free. */
  public boolean free(int axis) {
    return switch (axis) {
      case 0 -> x;
      case 1 -> y;
      case 2 -> z;
      case 3 -> rx;
      case 4 -> ry;
      case 5 -> rz;
      default ->
          throw new IndexOutOfBoundsException("axis is " + axis + ", must be 0 to " + (COUNT - 1));
    };
  }

  /** The same with axis 0 to 5 free or locked. */
  public FreeAxes with(int axis, boolean free) {
    return new FreeAxes(
        axis == 0 ? free : x,
        axis == 1 ? free : y,
        axis == 2 ? free : z,
        axis == 3 ? free : rx,
        axis == 4 ? free : ry,
        axis == 5 ? free : rz);
  }

  /** Whether nothing is locked. */
  public boolean all() {
    return equals(ALL);
  }
}
