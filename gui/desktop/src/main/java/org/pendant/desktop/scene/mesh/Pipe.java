package org.pendant.desktop.scene.mesh;

import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/** Pipe: a tube along the z axis of its frame, from z = 0. */
final class Pipe {
  private static final double STEP_M = 1e-3;

  private final Matrix4fc frame;
  private final Matrix4f toLocal;
  private final double lengthM;
  private final Radius radius;

  /** How thick a tube is. */
  @FunctionalInterface
  interface Radius {
    /** The radius, m, at a share of the length, 0 to 1. */
    double atM(double share);
  }

  /**
   * @param frame frame of the tube in the link's
   * @param lengthM its length, m
   */
  Pipe(Matrix4fc frame, double lengthM, Radius radius) {
    this.frame = frame;
    this.toLocal = frame.invert(new Matrix4f());
    this.lengthM = lengthM;
    this.radius = radius;
  }

  double lengthM() {
    return lengthM;
  }

  double radiusM(double z) {
    return radius.atM(Math.clamp(z / lengthM, 0, 1));
  }

  /** The point of the link's frame at an angle, a distance from the axis and a height, m. */
  Vector3f point(double angleRad, double r, double z) {
    Vector3f local =
        new Vector3f((float) (r * Math.cos(angleRad)), (float) (r * Math.sin(angleRad)), (float) z);
    return frame.transformPosition(local);
  }

  /** A direction in the link's frame, from its parts away from the axis and along it. */
  Vector3f direction(double angleRad, double away, double along) {
    Vector3f local =
        new Vector3f(
            (float) (away * Math.cos(angleRad)),
            (float) (away * Math.sin(angleRad)),
            (float) along);
    return frame.transformDirection(local).normalize();
  }

  /** The outward normal at an angle and a height. */
  Vector3f normal(double angleRad, double z) {
    double slope = (radiusM(z + STEP_M) - radiusM(z - STEP_M)) / (2 * STEP_M);
    return direction(angleRad, 1, -slope);
  }

  /** Distance of a point of the link's frame from the surface, m, negative inside. */
  double distanceM(Vector3fc point) {
    Vector3f local = toLocal.transformPosition(point, new Vector3f());
    return Math.hypot(local.x, local.y) - radiusM(local.z);
  }

  /** The outward direction at a point of the link's frame. */
  Vector3f normal(Vector3fc point) {
    Vector3f local = toLocal.transformPosition(point, new Vector3f());
    return direction(Math.atan2(local.y, local.x), 1, 0);
  }
}
