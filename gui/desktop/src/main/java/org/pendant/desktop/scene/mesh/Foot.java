package org.pendant.desktop.scene.mesh;

import org.joml.Matrix4f;
import org.pendant.models.shape.Base;

/** Foot: the fixed one, a plate with screws, and the body of the first joint on it. */
final class Foot {
  private static final double THICKEST_PLATE_M = 0.014;
  private static final int SCREWS = 4;

  /** Narrowest rim of the plate that screws fit on, m. */
  private static final double RIM_M = 0.008;

  private Foot() {}

  /**
   * @param topM where the shoulder begins, m
   * @param detail how finely it is cut
   */
  static Mesh of(Base base, double topM, Detail detail) {
    MeshBuilder mesh = new MeshBuilder(detail);
    double plateM = Math.min(THICKEST_PLATE_M, 0.45 * topM);
    double footM = base.footRadiusM();
    double bodyM = base.topRadiusM();
    mesh.at(new Matrix4f()).finish(Finish.METAL);
    Lathe.cylinder(mesh, footM, 0, plateM, 0.0025, Lathe.AROUND);
    mesh.finish(Finish.SHELL);
    double rootM = Math.min(footM - 0.002, bodyM + Math.max(0.004, 0.3 * (footM - bodyM)));
    LatheProfile body = new LatheProfile().to(0, plateM / 2);
    if (rootM > bodyM) {
      double neckM = Math.min(topM - 0.004, plateM + 0.25 * (topM - plateM));
      body.to(rootM, plateM / 2).to(rootM, plateM + 0.002, 0.002).to(bodyM, neckM, 0.02);
    } else {
      body.to(bodyM, plateM / 2);
    }
    Lathe.turn(mesh, body.to(bodyM, topM, 0.0015).to(0, topM));
    if (footM - rootM > RIM_M) {
      addScrews(mesh, (footM + rootM) / 2, Math.min(0.0055, 0.35 * (footM - rootM)), plateM);
    }
    return mesh.build();
  }

  private static void addScrews(MeshBuilder mesh, double circleM, double radiusM, double plateM) {
    mesh.finish(Finish.SEAL);
    for (int i = 0; i < SCREWS; i++) {
      double angle = 2 * Math.PI * (i + 0.5) / SCREWS;
      mesh.at(AxisDirection.UP_Z.at(circleM * Math.cos(angle), circleM * Math.sin(angle), 0));
      Lathe.cylinder(mesh, radiusM, plateM / 2, plateM + 0.0035, 8e-4, 20);
    }
  }
}
