package org.pendant.desktop.scene.view;

import java.util.Optional;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Ray;

/**
 * Drag plane: the plane in the base frame that the pointer moves something in.
 *
 * @param throughM a point of it, m
 * @param normal at a right angle to it, of any length
 */
record DragPlane(Vector3 throughM, Vector3 normal) {
  /** Rays that run along the plane meet it nowhere near. */
  private static final double MIN_COSINE = 0.05;

  /** Where a ray meets it, m; empty if it does not in front of the eye, or at a flat angle. */
  Optional<Vector3> meet(Ray ray) {
    double along = dot(ray.direction(), normal) / normal.length();
    // a normal of no length gives no number
    if (!(Math.abs(along) >= MIN_COSINE)) {
      return Optional.empty();
    }
    Vector3 from = ray.fromM();
    Vector3 way =
        new Vector3(throughM.x() - from.x(), throughM.y() - from.y(), throughM.z() - from.z());
    double distanceM = dot(way, normal) / normal.length() / along;
    return distanceM > 0 ? Optional.of(ray.pointM(distanceM)) : Optional.empty();
  }

  private static double dot(Vector3 a, Vector3 b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
  }
}
