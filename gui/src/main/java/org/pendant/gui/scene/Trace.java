package org.pendant.gui.scene;

/**
 * The way that the tool centre point took, in the base frame; immutable. A {@link TraceRing} makes
 * them.
 */
public final class Trace {
  /** No way at all. */
  public static final Trace EMPTY = new Trace(new float[0], 0);

  /** Numbers of a point: x, y, z, m, and its speed, m/s, below 0 where a new line begins. */
  static final int STRIDE = 4;

  private final float[] points;
  private final double fastestMPerS;

  Trace(float[] points, double fastestMPerS) {
    this.points = points;
    this.fastestMPerS = fastestMPerS;
  }

  /** How many points there are. */
  public int size() {
    return points.length / STRIDE;
  }

  /** Position of point {@code i}, m. */
  public float x(int i) {
    return points[STRIDE * i];
  }

  /** Position of point {@code i}, m. */
  public float y(int i) {
    return points[STRIDE * i + 1];
  }

  /** Position of point {@code i}, m. */
  public float z(int i) {
    return points[STRIDE * i + 2];
  }

  /** Whether no line leads from the point before to point {@code i}. */
  public boolean begins(int i) {
    return i == 0 || points[STRIDE * i + 3] < 0;
  }

  /** Speed on the way to point {@code i} as a share, 0 to 1, of the fastest of all. */
  public float speedShare(int i) {
    float speed = Math.max(points[STRIDE * i + 3], 0);
    return fastestMPerS > 0 ? (float) (speed / fastestMPerS) : 0;
  }

  /** Speed that is drawn in the colour of the fastest, m/s. */
  public double fastestMPerS() {
    return fastestMPerS;
  }
}
