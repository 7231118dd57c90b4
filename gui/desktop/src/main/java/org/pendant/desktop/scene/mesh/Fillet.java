package org.pendant.desktop.scene.mesh;

import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Fillet: the surface that leads from a tube to a barrel: where a smooth minimum of both distances
 * is zero (I. Quilez, "Smooth minimum"). Where both surfaces face the same way there is nothing to
 * fill, and the smoothing goes to zero: otherwise two equal cylinders would swell where they touch.
 *
 * @param sizeM how far it reaches along either surface where they are square to each other, m
 */
record Fillet(Pipe pipe, Barrel barrel, double sizeM) {
  private static final float DIFFERENCE_M = 1e-4f;
  private static final int ITERATIONS = 5;

  /** Moves a point on to the surface. */
  void attract(Vector3f point) {
    for (int i = 0; i < ITERATIONS; i++) {
      point.fma((float) -distanceM(point), normal(point));
    }
  }

  /** The outward normal at a point. */
  Vector3f normal(Vector3fc point) {
    Vector3f gradient = new Vector3f();
    for (int i = 0; i < 3; i++) {
      Vector3f step = new Vector3f().setComponent(i, DIFFERENCE_M);
      double ahead = distanceM(point.add(step, new Vector3f()));
      double behind = distanceM(point.sub(step, new Vector3f()));
      gradient.setComponent(i, (float) (ahead - behind));
    }
    return gradient.normalize();
  }

  private double distanceM(Vector3fc point) {
    double toTube = pipe.distanceM(point);
    double toBarrel = barrel.distanceM(point);
    double facing = pipe.normal(point).dot(barrel.normal(point));
    double smoothing = sizeM * Math.clamp(1 - facing, 1e-6, 1);
    double overlap = Math.max(smoothing - Math.abs(toTube - toBarrel), 0) / smoothing;
    return Math.min(toTube, toBarrel) - overlap * overlap * smoothing / 4;
  }
}
