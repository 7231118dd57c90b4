package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;

final class GroundTest {
  private static SceneObject plane(String name, Vector3 point, Vector3 normal) {
    return new SceneObject.Plane(name, point, normal, Material.DEFAULT);
  }

  private static Ground ground(Set<String> touched, SceneObject... objects) {
    Scene scene = new Scene(List.of(objects), Optional.empty(), List.of());
    return Ground.of(Models.of("ur5e").withWorld(scene, touched));
  }

  @Test
  void withoutASceneTheFloorIsUnderTheFoot() {
    assertEquals(new Ground(0, false, List.of()), ground(Set.of()));
  }

  @Test
  void theLowestPlaneThatFacesUpIsTheFloor() {
    Ground ground =
        ground(
            Set.of(),
            plane("table", new Vector3(0, 0, -0.1), new Vector3(0, 0, 1)),
            plane("floor", new Vector3(0, 0, -0.8), new Vector3(0, 0, 2)),
            plane("ceiling", new Vector3(0, 0, 2), new Vector3(0, 0, -1)));

    assertEquals(-0.8, ground.heightM());
    assertEquals(2, ground.planes().size());
  }

  @Test
  void aTouchedFloorIsKnown() {
    SceneObject floor = plane("floor", new Vector3(0, 0, 0), new Vector3(0, 0, 1));

    assertTrue(ground(Set.of("floor"), floor).touched());
    assertFalse(ground(Set.of(), floor).touched());
  }

  @Test
  void aWallIsDrawnWhereItIsNextToTheShoulder() {
    Ground ground =
        ground(Set.of("wall"), plane("wall", new Vector3(0, 0.7, 5), new Vector3(0, -3, 0)));

    Ground.Patch wall = ground.planes().getFirst();
    Vector3f origin = wall.frame().getTranslation(new Vector3f());
    Vector3f normal = wall.frame().transformDirection(new Vector3f(0, 0, 1));
    assertTrue(wall.touched());
    assertTrue(origin.distance(0, 0.7f, 0.1625f) < 1e-5, origin.toString());
    assertTrue(normal.distance(0, -1, 0) < 1e-5, normal.toString());
    assertEquals(1, wall.frame().determinant(), 1e-5);
  }
}
