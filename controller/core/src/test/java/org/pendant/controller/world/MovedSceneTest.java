package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;

final class MovedSceneTest {
  private static final SceneObject.Box BOX =
      new SceneObject.Box("box", Pose.ZERO, new Vector3(0.1, 0.1, 0.1), Material.DEFAULT, 1);

  private static final SceneObject.Compound LONG =
      new SceneObject.Compound(
          "long",
          new Pose(1, 0, 0, 0, 0, 0),
          List.of(
              new SceneObject.Box(
                  "end", new Pose(0, 0, 2, 0, 0, 0), new Vector3(1, 1, 1), Material.DEFAULT)),
          Material.DEFAULT,
          1);

  private static List<SceneObject> moved(MovedObject... moved) {
    Scene scene = new Scene(List.of(BOX, LONG), Optional.empty(), List.of());
    return MovedScene.of(scene, List.of(moved)).objects();
  }

  @Test
  void objectsAreWhereTheyHaveMovedTo() {
    List<SceneObject> now = moved(new MovedObject("long", new Pose(2, 0, 1, 0, 0, 0)));
    assertEquals(List.of(BOX, LONG.weighing(0).at(new Pose(2, 0, 1, 0, 0, 0))), now);
    assertEquals(new Pose(2, 0, 3, 0, 0, 0), now.getLast().pieces().getFirst().poseInBase());
  }

  @Test
  void whatHasFallenOutOfTheSpaceOfASceneIsNotThere() {
    assertEquals(List.of(LONG), moved(new MovedObject("box", new Pose(0, 0, -10.1, 0, 0, 0))));
    assertEquals(List.of(BOX), moved(new MovedObject("long", new Pose(0, 0, 8.1, 0, 0, 0))));
    assertTrue(
        moved(
                new MovedObject("box", new Pose(0, 11, 0, 0, 0, 0)),
                new MovedObject("long", new Pose(0, 0, 800, 0, 0, 0)))
            .isEmpty());
  }
}
