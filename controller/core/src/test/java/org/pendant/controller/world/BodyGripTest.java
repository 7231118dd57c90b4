package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

final class BodyGripTest {
  private static final double STEP_S = 0.002;
  private static final Vector3 TOP = new Vector3(0.4, 0, 0.1);

  private final ContactWorld world = world(1);
  private final double[] now = new double[Transforms.SIZE];

  private static ContactWorld world(double massKg) {
    return new ContactWorld(
        new Scene(
            List.of(
                new SceneObject.Plane(
                    "table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT),
                new SceneObject.Box(
                    "part",
                    new Pose(0.4, 0, 0.05, 0, 0, 0),
                    new Vector3(0.1, 0.1, 0.1),
                    Material.DEFAULT,
                    massKg)),
            Optional.empty(),
            List.of()));
  }

  /** Lets time pass while the hand holds on. */
  private void carry(ContactWorld in, Vector3 to, int steps) {
    for (int i = 0; i < steps; i++) {
      if (i % 50 == 0) {
        in.carry("part", TOP, to);
      }
      advance(in, 1);
    }
  }

  private static void advance(ContactWorld in, int steps) {
    double[] flange = new double[Transforms.SIZE];
    Transforms.of(new Pose(0, 0, 2, 0, 0, 0), flange);
    for (int i = 0; i < steps; i++) {
      in.advance(flange, new double[3], new double[6], STEP_S);
    }
  }

  @Test
  void aPartIsLiftedAndCarriedUpright() {
    carry(world, new Vector3(0.2, 0.3, 0.4), 500);
    world.poseNow(1, now);
    assertEquals(0.2, now[9], 1e-3);
    assertEquals(0.3, now[10], 1e-3);
    assertEquals(0.35, now[11], 1e-3);
    assertEquals(1, now[8], 1e-4, "its z is up");
    assertTrue(world.bodiesMove());
  }

  @Test
  void whatIsPutDownFallsAndRests() {
    carry(world, new Vector3(0.4, 0, 0.3), 500);
    world.putDown();
    advance(world, 1000);
    world.poseNow(1, now);
    assertEquals(0.05, now[11], 1e-3);
    assertFalse(world.bodiesMove());
  }

  @Test
  void aHandThatIsNotHeardOfAnyMoreLetsGo() {
    carry(world, new Vector3(0.4, 0, 0.3), 500);
    advance(world, 1000);
    world.poseNow(1, now);
    assertEquals(0.05, now[11], 1e-3);
  }

  @Test
  void whatIsTooHeavyStaysOnTheTable() {
    ContactWorld heavy = world(40);
    carry(heavy, new Vector3(0.4, 0, 0.5), 500);
    heavy.poseNow(1, now);
    assertEquals(0.05, now[11], 1e-3);
  }

  @Test
  void onlyWhatHasAMassIsCarried() {
    Vector3 to = new Vector3(0, 0, 1);
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> world.carry("table", TOP, to));
    assertEquals(
        "object is \"table\", must be one with a mass that is in the cell", refused.getMessage());
    assertThrows(
        IllegalArgumentException.class,
        () -> world.carry("part", TOP, new Vector3(0, 0, Double.NaN)));
    assertThrows(
        IllegalArgumentException.class, () -> new ContactWorld(Scene.EMPTY).carry("part", TOP, to));
  }
}
