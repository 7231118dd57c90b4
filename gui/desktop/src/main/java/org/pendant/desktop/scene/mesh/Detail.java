package org.pendant.desktop.scene.mesh;

/**
 * Detail: how finely round things are cut. On a machine without a GPU the number of triangles is
 * what takes the time, far more than the number of pixels.
 */
public enum Detail {
  /** No corner is seen, however near the eye is. */
  FINE,
  /** A quarter of the triangles and less: for what moves, and for shadows. */
  COARSE;

  /** Corners of a circle that has {@code fine} of them at best. */
  int around(int fine) {
    return this == FINE ? fine : Math.max(8, fine * 5 / 12);
  }

  /** Steps of a curve that has {@code fine} of them at best. */
  int steps(int fine) {
    return this == FINE ? fine : Math.max(1, (fine + 1) / 3);
  }
}
