package org.pendant.desktop.scene.mesh;

import org.joml.Matrix4f;
import org.pendant.models.shape.Cylinder;
import org.pendant.models.shape.JointHousing;

/**
 * Flange mesh: the last link, its body, the metal flange with its threads, and the socket of the
 * tool's cable.
 */
final class FlangeMesh {
  private static final int THREADS = 4;

  private final Cylinder body;
  private final Cylinder socket;

  FlangeMesh(JointHousing wrist3) {
    body = wrist3.alongZ();
    socket = wrist3.alongY();
  }

  /**
   * @param startM where it begins on z, m
   */
  void addTo(MeshBuilder mesh, double startM) {
    double faceM = Math.min(0, body.toM()) - 4e-4;
    double plateM = Math.min(0.009, 0.3 * (faceM - startM));
    double radiusM = body.radiusM();
    mesh.at(new Matrix4f()).finish(Finish.SHELL);
    Lathe.cylinder(mesh, radiusM, startM, faceM - plateM, 0.0025, Lathe.AROUND);
    addPlate(mesh, 0.9 * radiusM, faceM, plateM);
    addThreads(mesh, 0.67 * radiusM, 0.085 * radiusM, faceM);
    addSocket(mesh, (startM + faceM - plateM) / 2, 0.35 * (faceM - plateM - startM));
  }

  /** The plate has a centring bore. */
  private static void addPlate(MeshBuilder mesh, double radiusM, double faceM, double plateM) {
    double boreM = 0.48 * radiusM;
    double bottomM = faceM - 0.7 * plateM;
    mesh.finish(Finish.METAL);
    Lathe.turn(
        mesh,
        new LatheProfile()
            .to(0, faceM - plateM - 0.002)
            .to(radiusM, faceM - plateM - 0.002)
            .to(radiusM, faceM, 8e-4)
            .to(boreM, faceM, 6e-4)
            .to(boreM, bottomM)
            .to(0, bottomM));
  }

  private static void addThreads(MeshBuilder mesh, double circleM, double radiusM, double faceM) {
    mesh.finish(Finish.SEAL);
    for (int i = 0; i < THREADS; i++) {
      double angle = 2 * Math.PI * (i + 0.5) / THREADS;
      mesh.at(AxisDirection.UP_Z.at(circleM * Math.cos(angle), circleM * Math.sin(angle), 0));
      Lathe.cylinder(mesh, radiusM, faceM - 0.002, faceM + 3e-4, 0, 16);
    }
  }

  private void addSocket(MeshBuilder mesh, double middleM, double maxPartWidthM) {
    double reachM = -socket.fromM();
    if (reachM > body.radiusM()) {
      double radiusM = Math.min(maxPartWidthM, 0.2 * body.radiusM());
      mesh.at(AxisDirection.DOWN_Y.at(0, 0, middleM)).finish(Finish.SEAL);
      Lathe.cylinder(mesh, radiusM, 0.6 * body.radiusM(), reachM, 0.001, 24);
    }
  }
}
