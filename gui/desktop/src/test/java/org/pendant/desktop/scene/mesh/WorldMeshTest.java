package org.pendant.desktop.scene.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;

final class WorldMeshTest {
  private static final SceneObject BOX =
      new SceneObject.Box(
          "box",
          new Pose(0.5, 0, 0.1, 0, 0, Math.PI / 2),
          new Vector3(0.4, 0.2, 0.1),
          Material.DEFAULT);
  private static final SceneObject BALL =
      new SceneObject.Sphere("ball", new Vector3(-0.5, 0.2, 0.1), 0.1, Material.DEFAULT);

  @Test
  void aBoxHasItsSizeAndPlace() {
    Mesh.Box box = WorldMesh.of(List.of(BOX), Set.of(), Detail.FINE).box();

    assertEquals(0.4, box.lowX(), 1e-6);
    assertEquals(0.6, box.highX(), 1e-6);
    assertEquals(-0.2, box.lowY(), 1e-6);
    assertEquals(0.2, box.highY(), 1e-6);
    assertEquals(0.05, box.lowZ(), 1e-6);
    assertEquals(0.15, box.highZ(), 1e-6);
  }

  @Test
  void boxesAreClosedAndFaceOutwards() {
    Mesh mesh = WorldMesh.of(List.of(BOX), Set.of(), Detail.FINE);

    assertEquals(0, MeshChecks.openEdges(mesh));
    assertEquals(0.4 * 0.2 * 0.1, MeshChecks.volumeM3(mesh), 3e-5);
    assertEquals(0, MeshChecks.turnedShare(mesh));
  }

  @Test
  void ballsAreClosedAndFaceOutwards() {
    Mesh mesh = WorldMesh.of(List.of(BALL), Set.of(), Detail.FINE);

    assertEquals(0, MeshChecks.openEdges(mesh));
    assertEquals(4 * Math.PI / 3 * 1e-3, MeshChecks.volumeM3(mesh), 5e-5);
    assertEquals(0, MeshChecks.turnedShare(mesh));
  }

  @ParameterizedTest
  @CsvSource({"false, 0.006283", "true, 0.010472"})
  void rodsAreClosedAndFaceOutwards(boolean capsule, double volumeM3) {
    SceneObject rod =
        new SceneObject.Rod(
            "rod", new Pose(0.5, 0, 0.2, 1, 0, 0), 0.1, 0.2, capsule, Material.DEFAULT, 0);
    Mesh mesh = WorldMesh.of(List.of(rod), Set.of(), Detail.FINE);

    assertEquals(0, MeshChecks.openEdges(mesh));
    assertEquals(volumeM3, MeshChecks.volumeM3(mesh), 0.01 * volumeM3);
    assertEquals(0, MeshChecks.turnedShare(mesh));
  }

  @Test
  void whatIsTouchedLooksTouched() {
    Mesh mesh = WorldMesh.of(List.of(BOX, BALL), Set.of("ball"), Detail.FINE);

    assertEquals(Finish.OBJECT.number(), mesh.finish(0));
    assertEquals(Finish.TOUCHED.number(), mesh.finish(mesh.vertexCount() - 1));
  }

  @Test
  void planesHaveNoTriangles() {
    SceneObject plane =
        new SceneObject.Plane(
            "floor", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT);

    assertEquals(0, WorldMesh.of(List.of(plane), Set.of(), Detail.FINE).triangleCount());
  }

  @Test
  void marksAreClosed() {
    assertEquals(0, MeshChecks.openEdges(Marks.frame(Detail.FINE)));
    assertEquals(0, MeshChecks.openEdges(Marks.rod(0.004, Detail.FINE)));
    assertTrue(MeshChecks.volumeM3(Marks.frame(Detail.FINE)) > 0);
  }
}
