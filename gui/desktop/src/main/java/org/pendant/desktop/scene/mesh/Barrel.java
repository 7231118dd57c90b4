package org.pendant.desktop.scene.mesh;

import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Barrel: a cylinder with rounded edges as a field of distances: what a tube grows out of.
 *
 * @param centre its middle, in the link's frame, m
 * @param axis its direction, of length 1
 * @param radiusM its radius, m
 * @param halfLengthM half its length, m
 * @param roundingM radius of its edges, m
 */
record Barrel(
    Vector3fc centre, Vector3fc axis, double radiusM, double halfLengthM, double roundingM) {

  /** Distance of a point of the link's frame from the surface, m, negative inside. */
  double distanceM(Vector3fc point) {
    Vector3f from = point.sub(centre, new Vector3f());
    double along = from.dot(axis);
    double beyondSide = across(from, along).length() - (radiusM - roundingM);
    double beyondEnd = Math.abs(along) - (halfLengthM - roundingM);
    double outside = Math.hypot(Math.max(beyondSide, 0), Math.max(beyondEnd, 0));
    return Math.min(Math.max(beyondSide, beyondEnd), 0) + outside - roundingM;
  }

  /** The direction in which the distance grows. */
  Vector3f normal(Vector3fc point) {
    Vector3f from = point.sub(centre, new Vector3f());
    double along = from.dot(axis);
    Vector3f sideways = across(from, along);
    double beyondSide = sideways.length() - (radiusM - roundingM);
    double beyondEnd = Math.abs(along) - (halfLengthM - roundingM);
    if (sideways.lengthSquared() > 0) {
      sideways.normalize();
    }
    Vector3f endways = axis.mul((float) Math.signum(along), new Vector3f());
    if (Math.max(beyondSide, beyondEnd) <= 0) {
      return beyondSide >= beyondEnd ? sideways : endways;
    }
    return sideways
        .mul((float) Math.max(beyondSide, 0))
        .fma((float) Math.max(beyondEnd, 0), endways)
        .normalize();
  }

  /** How far a point is from the nearer end, measured along the axis, m; negative past it. */
  double roomM(Vector3fc point) {
    return halfLengthM - Math.abs(point.sub(centre, new Vector3f()).dot(axis));
  }

  private Vector3f across(Vector3fc from, double along) {
    return new Vector3f(from).fma((float) -along, axis);
  }
}
