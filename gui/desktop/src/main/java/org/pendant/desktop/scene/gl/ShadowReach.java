package org.pendant.desktop.scene.gl;

import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.pendant.desktop.scene.mesh.Mesh;

/**
 * Shadow reach: the part of a level floor that shadows can reach: a rectangle around where the
 * corners of boxes throw theirs. Elsewhere no lookup is needed.
 */
final class ShadowReach {
  private static final int CORNERS = 8;

  private final Vector3fc toSun;
  private final float floorM;
  private final float limitM;
  private float lowX;
  private float lowY;
  private float highX;
  private float highY;

  /**
   * @param toSun direction of the light, above the horizon
   * @param floorM height of the floor, m
   * @param limitM nothing farther from the middle counts, m
   */
  ShadowReach(Vector3fc toSun, float floorM, float limitM) {
    this.toSun = toSun;
    this.floorM = floorM;
    this.limitM = limitM;
    lowX = limitM;
    lowY = limitM;
    highX = -limitM;
    highY = -limitM;
  }

  /** Counts a body: a box in a frame of its own. */
  void add(Mesh.Box box, Matrix4fc frame) {
    if (box.lowX() > box.highX()) {
      return;
    }
    Vector3f corner = new Vector3f();
    for (int i = 0; i < CORNERS; i++) {
      corner.set(
          (i & 1) == 0 ? box.lowX() : box.highX(),
          (i & 2) == 0 ? box.lowY() : box.highY(),
          (i & 4) == 0 ? box.lowZ() : box.highZ());
      frame.transformPosition(corner);
      float along = (corner.z - floorM) / toSun.z();
      float x = Math.clamp(corner.x - along * toSun.x(), -limitM, limitM);
      float y = Math.clamp(corner.y - along * toSun.y(), -limitM, limitM);
      lowX = Math.min(lowX, x);
      lowY = Math.min(lowY, y);
      highX = Math.max(highX, x);
      highY = Math.max(highY, y);
    }
  }

  /** Made wider on each side, m, for what is soft; from x, y to x, y. */
  float[] rectangle(float marginM) {
    if (lowX > highX) {
      return new float[4];
    }
    return new float[] {
      Math.max(lowX - marginM, -limitM),
      Math.max(lowY - marginM, -limitM),
      Math.min(highX + marginM, limitM),
      Math.min(highY + marginM, limitM)
    };
  }
}
