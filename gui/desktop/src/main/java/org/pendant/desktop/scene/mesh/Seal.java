package org.pendant.desktop.scene.mesh;

import org.joml.Matrix4fc;

/** Seal: the dark ring in the gap between two links; it belongs to the one that turns. */
final class Seal {
  private static final double NARROWER_M = 0.004;
  private static final double HALF_WIDTH_M = 0.003;

  private Seal() {}

  /**
   * @param frame with the origin in the face between the two and z along the axis of the joint
   * @param radiusM of the narrower link, m
   */
  static void add(MeshBuilder mesh, Matrix4fc frame, double radiusM) {
    mesh.at(frame).finish(Finish.SEAL);
    Lathe.cylinder(mesh, radiusM - NARROWER_M, -HALF_WIDTH_M, HALF_WIDTH_M, 0, Lathe.AROUND);
  }
}
