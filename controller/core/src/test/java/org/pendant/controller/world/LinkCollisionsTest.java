package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

class LinkCollisionsTest {
  private static final ArmDescription UR5E = ArmLibrary.load("ur5e");
  private static final double HALF = Math.PI / 2;

  /** A post where the elbow comes by when the base turns. */
  private static final SceneObject POST =
      new SceneObject.Box(
          "post", new Pose(0, -0.4, 0.3, 0, 0, 0), new Vector3(0.05, 0.05, 0.6), Material.DEFAULT);

  private static Scene scene(SceneObject... objects) {
    return new Scene(List.of(objects), Optional.empty(), List.of());
  }

  private static LinkCollisions of(Scene scene) {
    return LinkCollisions.of(UR5E, scene).orElseThrow();
  }

  /** Stretched out level, turned about the base. */
  private static double[] level(double base) {
    return new double[] {base, 0, 0, -HALF, HALF, 0};
  }

  private static Optional<LinkHit> sweep(LinkCollisions links, double from, double to) {
    for (int i = 0; i <= 1000; i++) {
      Optional<LinkHit> hit = links.look(level(from + (to - from) * i / 1000), false);
      if (hit.isPresent()) {
        return hit;
      }
    }
    return Optional.empty();
  }

  @Test
  void aLinkThatGetsIntoAnObjectIsTold() {
    LinkHit hit = sweep(of(scene(POST)), 0, HALF).orElseThrow();
    assertEquals("the upper arm has hit \"post\"", hit.sentence());
    assertEquals(1, hit.joint());
    assertTrue(hit.depthM() > 0 && hit.depthM() < 0.002, hit::toString);
  }

  @Test
  void aLinkThatGetsIntoAnotherIsTold() {
    LinkCollisions links = of(scene(POST));
    Optional<LinkHit> hit = Optional.empty();
    for (int i = 0; i < 3000 && hit.isEmpty(); i++) {
      hit = links.look(new double[] {0, -HALF, i * 0.001, 0, 0, 0}, false);
    }
    assertEquals("the wrist 2 has hit the upper arm", hit.orElseThrow().sentence());
    assertEquals(4, hit.orElseThrow().joint());
  }

  @Test
  void whatWasInAnObjectAtFirstMayBeThereUntilItHasLeft() {
    LinkCollisions links = of(scene(POST));
    assertTrue(sweep(links, HALF, HALF + 1).isEmpty());
    assertTrue(sweep(links, HALF + 1, HALF).isPresent());
  }

  @Test
  void whatHasGotInMayLeaveButNotGetDeeper() {
    LinkCollisions links = of(scene(POST));
    double at = angleOfHit(links);
    assertTrue(sweep(links, at, at - 0.5).isEmpty());
    assertEquals(at, angleOfHit(links), 2e-3);
    assertTrue(sweep(links, at, at + 0.1).isPresent());
  }

  private static double angleOfHit(LinkCollisions links) {
    for (double angle = 0.5; angle < HALF; angle += 1e-3) {
      if (links.look(level(angle), false).isPresent()) {
        return angle;
      }
    }
    throw new IllegalStateException("nothing was hit");
  }

  @Test
  void whatGotInWhileThatWasToleratedMayStayThere() {
    LinkCollisions links = of(scene(POST));
    for (double angle = 0; angle < 1; angle += 1e-3) {
      assertTrue(links.look(level(angle), true).isEmpty());
    }
    assertEquals(Optional.empty(), links.look(level(1), false));
    assertTrue(sweep(links, 1, 0).isEmpty());
  }

  @Test
  void anArmPutIntoAnObjectMayBeThere() {
    LinkCollisions links = of(scene(POST));
    assertTrue(links.look(level(0), false).isEmpty());
    links.restart();
    assertTrue(links.look(level(HALF), false).isEmpty());
  }

  @Test
  void lookingOnlyWhenTheArmCouldTouchFindsWhatLookingAlwaysDoes() {
    Random random = new Random(11);
    Scene scene =
        scene(
            POST,
            new SceneObject.Plane(
                "table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT),
            new SceneObject.Sphere("ball", new Vector3(0.4, 0.4, 0.4), 0.1, Material.DEFAULT));
    ArmSurroundings always = new ArmSurroundings(UR5E, scene);
    int hits = 0;
    for (int n = 0; n < 200; n++) {
      LinkCollisions links = of(scene);
      // with a bare flange wrist 3 may touch objects
      links.setTool(new Pose(0, 0, 0.1, 0, 0, 0));
      double[] q = {6 * random.nextDouble(), -HALF, -HALF, -HALF, HALF, 0};
      double[] step = new double[6];
      for (int i = 0; i < 6; i++) {
        step[i] = 0.02 * (random.nextDouble() - 0.5);
      }
      boolean clearAtFirst = clear(always, q);
      for (int i = 0; i < 150; i++) {
        boolean told = links.look(q, false).isPresent();
        boolean in = !clear(always, q);
        assertTrue(!clearAtFirst || told == in, "sweep " + n + ", step " + i);
        if (in) {
          hits++;
          break;
        }
        for (int j = 0; j < 6; j++) {
          q[j] += step[j];
        }
      }
    }
    assertTrue(hits > 30, "only " + hits);
  }

  private static boolean clear(ArmSurroundings clearance, double[] q) {
    clearance.at(q);
    for (int pair = 0; pair < clearance.pairs(); pair++) {
      if (clearance.distanceM(pair, 1) < 0) {
        return false;
      }
    }
    return true;
  }

  @Test
  void aBareFlangePressesWithoutAStopAndOneWithAToolDoesNot() {
    Scene table =
        scene(
            new SceneObject.Box(
                "table",
                new Pose(-0.8, -0.13, 0, 0, 0, 0),
                new Vector3(0.3, 0.3, 0.1),
                Material.DEFAULT));
    LinkCollisions bare = of(table);
    assertTrue(press(bare).isEmpty());
    LinkCollisions tool = of(table);
    tool.setTool(new Pose(0, 0, 0.1, 0, 0, 0));
    assertEquals("wrist 3", press(tool).orElseThrow().link());
  }

  private static Optional<LinkHit> press(LinkCollisions links) {
    Optional<LinkHit> hit = Optional.empty();
    for (double shoulder = -0.3; shoulder < 0.03 && hit.isEmpty(); shoulder += 1e-3) {
      hit = links.look(new double[] {0, shoulder, 0, -HALF - shoulder, -HALF, 0}, false);
    }
    return hit;
  }

  @Test
  void aBallOfTheToolHitsLinksAndPressesOnObjects() {
    Scene scene =
        new Scene(
            List.of(
                new SceneObject.Sphere("ball", new Vector3(-0.8, -0.13, 0), 0.2, Material.DEFAULT)),
            Optional.empty(),
            List.of(new ToolPoint(new Vector3(0, 0, 0.15), 0.03)));
    LinkCollisions links = of(scene);
    Optional<LinkHit> hit = Optional.empty();
    for (double elbow = 1.5; elbow < 3 && hit.isEmpty(); elbow += 1e-3) {
      hit = links.look(new double[] {0, -HALF, elbow, 0, -HALF, 0}, false);
    }
    assertEquals("tool", hit.orElseThrow().link());
    assertFalse(hit.orElseThrow().object());
    assertEquals(5, hit.orElseThrow().joint());
  }

  @Test
  void thereAreNoneWhereLinksPassThroughAndWithoutAScene() {
    assertTrue(LinkCollisions.of(UR5E, scene(POST).withLinks(LinkContact.PASS)).isEmpty());
    assertTrue(LinkCollisions.of(UR5E, Scene.EMPTY).isEmpty());
  }

  @Test
  void theShoulderAboveAFloorAndAnUpperArmThatPointsUpAreNotTheNearest() {
    SceneObject floor =
        new SceneObject.Plane(
            "floor", new Vector3(0, 0, 0.06), new Vector3(0, 0, 1), Material.DEFAULT);
    ArmSurroundings above = new ArmSurroundings(UR5E, scene(floor));
    Joints upright = new Joints(0, -HALF, 0, -HALF, HALF, 0);
    Pose tool = new Pose(0, 0, 0.1, 0, 0, 0);
    // the shoulder is 39 mm above it whatever joints do, the upper arm 42 mm while it points up
    assertTrue(above.nearest(upright, tool, new double[0]).objectM() > 0.3);
    Joints bent = new Joints(0, -0.3, 0.6, -HALF, HALF, 0);
    assertTrue(above.nearest(bent, tool, new double[0]).objectM() < 0.03);
  }

  @Test
  void theNearestObjectIsFartherThanLinksOfTheArmAreFromOneAnother() {
    Joints down = new Joints(0, -HALF, -HALF, -HALF, HALF, 0);
    Pose tool = new Pose(0, 0, 0.1, 0, 0, 0);
    LinkDistances alone = new ArmSurroundings(UR5E, Scene.EMPTY).nearest(down, tool, new double[0]);
    // forearm and wrist 3, with the tool down
    assertEquals(0.097, alone.nearestM(), 1e-3);
    assertEquals(Double.NaN, alone.objectM());

    SceneObject ball =
        new SceneObject.Sphere("ball", new Vector3(0.5, 0.2, 0.1), 0.05, Material.DEFAULT);
    LinkDistances beside =
        new ArmSurroundings(UR5E, scene(ball)).nearest(down, tool, new double[0]);
    assertEquals(alone.nearestM(), beside.nearestM(), 1e-9);
    assertTrue(beside.objectM() > 0.15, beside::toString);
  }
}
