package org.pendant.desktop.scene.mesh;

import java.util.Arrays;

/** Lines in the base frame, each from point to point, with a colour at every point. */
public final class Lines {
  /** Numbers of a point: x, y, z, m, 1 where a line begins, then red, green, blue and opacity. */
  public static final int STRIDE = 8;

  private float[] points = new float[STRIDE * 64];
  private int count;

  /** Begins a line; colour as 0xRRGGBB, opacity 0 to 1. */
  public Lines from(double x, double y, double z, int rgb, double opacity) {
    return add(x, y, z, 1, rgb, opacity);
  }

  /** Continues to a point; colour as 0xRRGGBB, opacity 0 to 1. */
  public Lines to(double x, double y, double z, int rgb, double opacity) {
    return add(x, y, z, 0, rgb, opacity);
  }

  private Lines add(double x, double y, double z, float begins, int rgb, double opacity) {
    if (STRIDE * (count + 1) > points.length) {
      points = Arrays.copyOf(points, 2 * points.length);
    }
    int at = STRIDE * count++;
    points[at] = (float) x;
    points[at + 1] = (float) y;
    points[at + 2] = (float) z;
    points[at + 3] = begins;
    points[at + 4] = (rgb >> 16 & 0xFF) / 255f;
    points[at + 5] = (rgb >> 8 & 0xFF) / 255f;
    points[at + 6] = (rgb & 0xFF) / 255f;
    points[at + 7] = (float) opacity;
    return this;
  }

  /** How many points there are. */
  public int size() {
    return count;
  }

  /** Number {@code k}, 0 to {@link #STRIDE} - 1, of point {@code i}. */
  public float number(int i, int k) {
    return points[STRIDE * i + k];
  }

  /** All numbers, point after point, in a new array. */
  public float[] numbers() {
    return Arrays.copyOf(points, STRIDE * count);
  }
}
