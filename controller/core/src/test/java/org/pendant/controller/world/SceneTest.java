package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.pendant.models.pose.Pose;

final class SceneTest {
  private static final Vector3 ORIGIN = new Vector3(0, 0, 0);
  private static final Vector3 UP = new Vector3(0, 0, 1);
  private static final Vector3 UNIT = new Vector3(1, 1, 1);

  private static SceneObject ball(String name) {
    return new SceneObject.Sphere(name, ORIGIN, 0.1, Material.DEFAULT);
  }

  private static void assertRefused(String message, Executable making) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, making).getMessage());
  }

  @Test
  void normalOfAPlaneIsKeptWithLengthOne() {
    assertEquals(
        UP,
        new SceneObject.Plane("floor", ORIGIN, new Vector3(0, 0, 250), Material.DEFAULT)
            .normalInBase());
  }

  @Test
  void objectsNeedNamesOfTheirOwn() {
    assertRefused(
        "name is \"ball\" again, must be another for each object",
        () -> new Scene(List.of(ball("ball"), ball("ball")), Optional.empty(), List.of()));
  }

  @Test
  void countsAreLimited() {
    assertRefused(
        "scene has 1001 objects, must be at most 1000",
        () -> new Scene(Collections.nCopies(1001, ball("b")), Optional.empty(), List.of()));
    assertRefused(
        "scene has 17 tool points, must be at most 16",
        () ->
            new Scene(
                List.of(), Optional.empty(), Collections.nCopies(17, new ToolPoint(ORIGIN, 0))));
  }

  @Test
  void namesAreShortAndCanBeShown() {
    assertRefused("name is \" \", must be 1 to 60 letters", () -> ball(" "));
    assertRefused("name is \"a?b\", must be 1 to 60 letters", () -> ball("a\nb"));
    assertRefused(
        "name is \"" + "x".repeat(40) + "...\", must be 1 to 60 letters",
        () -> ball("x".repeat(61)));
  }

  @Test
  void planesOutsideTheRangesAreRefused() {
    assertRefused(
        "point[1] is 11 m, must be -10 to 10 m",
        () -> new SceneObject.Plane("p", new Vector3(0, 11, 0), UP, Material.DEFAULT));
    assertRefused(
        "length of normal is 0, must be 0.001 to 1000",
        () -> new SceneObject.Plane("p", ORIGIN, ORIGIN, Material.DEFAULT));
  }

  @Test
  void boxesOutsideTheRangesAreRefused() {
    assertRefused(
        "pose[2] is NaN m, must be -10 to 10 m",
        () ->
            new SceneObject.Box("b", new Pose(0, 0, Double.NaN, 0, 0, 0), UNIT, Material.DEFAULT));
    assertRefused(
        "pose[3] is 180 rad, must be -100 to 100 rad",
        () -> new SceneObject.Box("b", new Pose(0, 0, 0, 180, 0, 0), UNIT, Material.DEFAULT));
    assertRefused(
        "size[0] is 0 m, must be 0.001 to 10 m",
        () -> new SceneObject.Box("b", Pose.ZERO, new Vector3(0, 1, 1), Material.DEFAULT));
  }

  @Test
  void spheresOutsideTheRangesAreRefused() {
    assertRefused(
        "centre[0] is -10.5 m, must be -10 to 10 m",
        () -> new SceneObject.Sphere("s", new Vector3(-10.5, 0, 0), 1, Material.DEFAULT));
    assertRefused(
        "radius is 10000000 m, must be 0.001 to 10 m",
        () -> new SceneObject.Sphere("s", ORIGIN, 1e7, Material.DEFAULT));
  }

  @Test
  void toolPointsOutsideTheRangesAreRefused() {
    assertRefused(
        "point[2] is 5 m, must be -4 to 4 m", () -> new ToolPoint(new Vector3(0, 0, 5), 0));
    assertRefused("radius is -1 m, must be 0 to 1 m", () -> new ToolPoint(ORIGIN, -1));
  }
}
