package org.pendant.desktop.scene;

import org.joml.Matrix4f;
import org.joml.Vector3f;

/** Plane frame: where the piece of an endless plane that is drawn lies. */
final class PlaneFrame {
  private PlaneFrame() {}

  /**
   * The frame of a plane: its z axis is the normal, its origin the point next to the shoulder, and
   * its x axis level.
   *
   * @param normal of length 1
   * @param point any point of the plane, m
   */
  static Matrix4f of(Vector3f normal, Vector3f point, double shoulderHeightM) {
    Vector3f shoulder = new Vector3f(0, 0, (float) shoulderHeightM);
    Vector3f origin =
        new Vector3f(shoulder).fma(new Vector3f(point).sub(shoulder).dot(normal), normal);
    Vector3f aside = Math.abs(normal.z) < 0.9f ? new Vector3f(0, 0, 1) : new Vector3f(0, 1, 0);
    Vector3f x = aside.cross(normal, new Vector3f()).normalize();
    Vector3f y = normal.cross(x, new Vector3f());
    return new Matrix4f(
        x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, normal.x, normal.y, normal.z, 0, origin.x, origin.y,
        origin.z, 1);
  }
}
