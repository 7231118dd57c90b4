package org.pendant.desktop.scene.mesh;

import org.joml.Matrix4f;

/** Axis direction: the direction that the z axis of a part has in the frame of its link. */
enum AxisDirection {
  UP_Z,
  DOWN_Z,
  UP_Y,
  DOWN_Y,
  DOWN_X;

  /** The frame of a part at a place, m. */
  Matrix4f at(double x, double y, double z) {
    Matrix4f frame = new Matrix4f().translation((float) x, (float) y, (float) z);
    float quarter = (float) (Math.PI / 2);
    return switch (this) {
      case UP_Z -> frame;
      case DOWN_Z -> frame.rotateX(2 * quarter);
      case UP_Y -> frame.rotateX(-quarter);
      case DOWN_Y -> frame.rotateX(quarter);
      case DOWN_X -> frame.rotateY(-quarter);
    };
  }
}
