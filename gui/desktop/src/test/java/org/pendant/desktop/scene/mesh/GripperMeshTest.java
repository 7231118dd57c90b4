package org.pendant.desktop.scene.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.GripperSetup;

final class GripperMeshTest {
  private static List<Mesh> of(GripperSetup.Grip grip, double reachM) {
    return GripperMesh.of(grip, reachM, 0.085, false, Detail.FINE);
  }

  @Test
  void allPartsAreClosedAndFaceOutwards() {
    for (GripperSetup.Grip grip :
        List.of(GripperSetup.Grip.Pads.DEFAULT, GripperSetup.Grip.Cup.DEFAULT)) {
      for (double reachM : List.of(0.0, 0.01, 0.16)) {
        for (Mesh mesh : of(grip, reachM)) {
          assertEquals(0, MeshChecks.openEdges(mesh));
          assertTrue(MeshChecks.volumeM3(mesh) >= 0);
        }
      }
    }
  }

  @Test
  void closedFingersMeetInTheMiddleAndReachBackToTheBody() {
    List<Mesh> meshes = of(GripperSetup.Grip.Pads.DEFAULT, 0.16);
    assertEquals(0, meshes.get(2).box().lowY(), 1e-6);
    assertEquals(0, meshes.get(3).box().highY(), 1e-6);
    double bodyEndsM = meshes.get(0).box().highZ();
    assertTrue(0.16 + meshes.get(2).box().lowZ() <= bodyEndsM + 0.002);
    assertEquals(0.011, meshes.get(2).box().highZ(), 1e-6);
  }
}
