package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

final class ContactWorldTest {
  private static final Material SOFT = new Material(1e4, 0.2, 0.5);

  private static final SceneObject TABLE =
      new SceneObject.Plane("table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), SOFT);

  private static void assertWrench(
      Wrench wrench, double fx, double fy, double fz, double mx, double my, double mz) {
    assertAll(
        () -> assertEquals(fx, wrench.fx(), 1e-9, "fx"),
        () -> assertEquals(fy, wrench.fy(), 1e-9, "fy"),
        () -> assertEquals(fz, wrench.fz(), 1e-9, "fz"),
        () -> assertEquals(mx, wrench.mx(), 1e-9, "mx"),
        () -> assertEquals(my, wrench.my(), 1e-9, "my"),
        () -> assertEquals(mz, wrench.mz(), 1e-9, "mz"));
  }

  @Test
  void pressingOneMillimetreIntoTheTableIsPushedUp() {
    assertWrench(ToolInWorld.among(TABLE).at(0.3, 0.2, -0.001).feels(), 0, 0, 10, 0, 0, 0);
  }

  @Test
  void aboveTheTableNothingIsFelt() {
    ToolInWorld tool = ToolInWorld.among(TABLE).at(0.3, 0.2, 0.0001);
    assertWrench(tool.feels(), 0, 0, 0, 0, 0, 0);
    assertFalse(tool.world.inContact());
    assertEquals(List.of(), tool.world.contacts());
  }

  @Test
  void nothingPushesUntilThereIsAnObjectOrAHand() {
    ContactWorld empty = new ContactWorld(Scene.EMPTY);
    assertTrue(empty.pushesNothing());
    assertFalse(ToolInWorld.among(TABLE).world.pushesNothing());
    empty.apply(new Wrench(0, 0, 1, 0, 0, 0));
    assertFalse(empty.pushesNothing());
    empty.release();
    assertTrue(empty.pushesNothing());
    empty.grip().push(5, new Vector3(0, 0, 0), new Vector3(0, 0, 1));
    assertFalse(empty.pushesNothing());
  }

  @Test
  void leavingFastIsNotHeldBack() {
    assertWrench(
        ToolInWorld.among(TABLE).at(0, 0, -0.001).moving(0.3, 0, 5).feels(), 0, 0, 0, 0, 0, 0);
  }

  @Test
  void frictionOpposesSliding() {
    assertWrench(
        ToolInWorld.among(TABLE).at(0, 0, -0.001).moving(0.03, -0.04, 0).feels(),
        -5 * 0.6,
        5 * 0.8,
        10,
        0,
        0,
        0);
  }

  @Test
  void turningSlidesTheToolCentrePointAlong() {
    Wrench wrench =
        ToolInWorld.among(TABLE).at(0, 0, 0.099).tcp(0, 0, -0.1).moving(0, 0, 0, 0, 1, 0).feels();
    // omega x r = (0, 1, 0) x (0, 0, -0.1) = (-0.1, 0, 0): friction points along +x
    assertWrench(wrench, 5, 0, 10, 0, -0.5, 0);
  }

  @Test
  void toolCentrePointIsTurnedWithTheFlange() {
    Wrench wrench =
        ToolInWorld.among(TABLE)
            .at(new Pose(0.4, 0, 0.199, Math.PI, 0, 0))
            .tcp(0, 0.05, 0.2)
            .feels();
    // upside down, the point is at (0, -0.05, -0.2) from the flange
    assertWrench(wrench, 0, 0, 10, -0.05 * 10, 0, 0);
  }

  @Test
  void twoToolPointsGiveAMomentWhenPressedUnevenly() {
    Scene scene =
        new Scene(
            List.of(TABLE),
            Optional.empty(),
            List.of(
                new ToolPoint(new Vector3(0.1, 0, -0.002), 0),
                new ToolPoint(new Vector3(-0.1, 0, -0.001), 0)));
    ToolInWorld tool = new ToolInWorld(scene).tcp(0, 0, -0.5);
    assertWrench(tool.feels(), 0, 0, 20 + 10, 0, 0.1 * (10 - 20), 0);
    assertEquals(List.of(new Contact("table", 0.002, 30)), tool.world.contacts());
  }

  @Test
  void ballAtTheToolTouchesWithItsUnderside() {
    Scene scene =
        new Scene(
            List.of(TABLE), Optional.empty(), List.of(new ToolPoint(new Vector3(0, 0, 0), 0.02)));
    ToolInWorld tool = new ToolInWorld(scene).at(0, 0, 0.019).moving(0.1, 0, 0);
    assertWrench(tool.feels(), -5, 0, 10, 0, 0.02 * 5, 0);
  }

  @Test
  void rollingBallDoesNotSlide() {
    Scene scene =
        new Scene(
            List.of(TABLE), Optional.empty(), List.of(new ToolPoint(new Vector3(0, 0, 0), 0.02)));
    ToolInWorld tool = new ToolInWorld(scene).at(0, 0, 0.019).moving(0.1, 0, 0, 0, 5, 0);
    assertWrench(tool.feels(), 0, 0, 10, 0, 0, 0);
  }

  @Test
  void forcesOfTwoObjectsAddUp() {
    SceneObject wall =
        new SceneObject.Plane("wall", new Vector3(0.5, 0, 0), new Vector3(-1, 0, 0), SOFT);
    ToolInWorld tool = ToolInWorld.among(TABLE, wall).at(0.502, 0, -0.001);
    assertWrench(tool.feels(), -20, 0, 10, 0, 0, 0);
    List<Contact> contacts = tool.world.contacts();
    assertAll(
        () -> assertEquals("table", contacts.get(0).object()),
        () -> assertEquals(0.001, contacts.get(0).depthM(), 1e-12),
        () -> assertEquals(10, contacts.get(0).forceN(), 1e-9),
        () -> assertEquals("wall", contacts.get(1).object()),
        () -> assertEquals(0.002, contacts.get(1).depthM(), 1e-12),
        () -> assertEquals(20, contacts.get(1).forceN(), 1e-9));
  }

  @Test
  void contactForceIncludesFriction() {
    ToolInWorld tool = ToolInWorld.among(TABLE).at(0, 0, -0.001).moving(0.1, 0, 0);
    tool.feels();
    assertTrue(tool.world.inContact());
    assertEquals(Math.hypot(10, 5), tool.world.contacts().getFirst().forceN(), 1e-9);
  }

  @Test
  void contactEndsWhenTheToolLeaves() {
    ToolInWorld tool = ToolInWorld.among(TABLE).at(0, 0, -0.001);
    tool.feels();
    assertTrue(tool.world.inContact());
    tool.at(0, 0, 0.001).feels();
    assertFalse(tool.world.inContact());
  }

  @Test
  void clearanceIsTheDistanceToTheNearestObject() {
    SceneObject wall =
        new SceneObject.Plane("wall", new Vector3(0.5, 0, 0), new Vector3(-1, 0, 0), SOFT);
    ToolInWorld tool = ToolInWorld.among(TABLE, wall);
    tool.at(0.47, 0, 0.1).feels();
    assertEquals(0.03, tool.world.clearanceM(), 1e-12);
    tool.at(0.47, 0, -0.002).feels();
    assertEquals(-0.002, tool.world.clearanceM(), 1e-12);
  }

  @Test
  void emptySpaceIsClearForEver() {
    ToolInWorld tool = new ToolInWorld(Scene.EMPTY);
    tool.feels();
    assertEquals(Double.POSITIVE_INFINITY, tool.world.clearanceM());
  }

  @Test
  void faceOfATurnedBoxPushesAlongItsNormal() {
    SceneObject box =
        new SceneObject.Box(
            "box", new Pose(0.5, 0, 0, 0, 0, Math.PI / 6), new Vector3(0.2, 0.2, 0.2), SOFT);
    double c = Math.cos(Math.PI / 6);
    double s = Math.sin(Math.PI / 6);
    assertWrench(
        ToolInWorld.among(box).at(0.5 - 0.098 * c, -0.098 * s, 0).feels(),
        -20 * c,
        -20 * s,
        0,
        0,
        0,
        0);
  }

  @Test
  void ballPushesAside() {
    SceneObject ball = new SceneObject.Sphere("ball", new Vector3(0, 0, 0), 0.1, SOFT);
    assertWrench(ToolInWorld.among(ball).at(0.06 * 0.99, 0, 0.08 * 0.99).feels(), 6, 0, 8, 0, 0, 0);
  }

  @Test
  void appliedForceActsAtTheToolCentrePoint() {
    ToolInWorld tool =
        new ToolInWorld(Scene.EMPTY).at(new Pose(0.4, 0.1, 0.3, Math.PI, 0, 0)).tcp(0, 0, 0.2);
    tool.world.apply(new Wrench(3, 0, -7, 0.1, 0.2, 0.3));
    // the point is 0.2 m below the flange: r x f = (0, 0, -0.2) x (3, 0, -7) = (0, -0.6, 0)
    assertWrench(tool.feels(), 3, 0, -7, 0.1, 0.2 - 0.6, 0.3);
    assertFalse(tool.world.inContact());
  }

  @Test
  void appliedWrenchStaysUntilReleased() {
    ToolInWorld tool = ToolInWorld.among(TABLE).at(0, 0, -0.001);
    Wrench push = new Wrench(0, 0, -4, 0, 0, 0);
    tool.world.apply(push);
    tool.feels();
    assertWrench(tool.feels(), 0, 0, 6, 0, 0, 0);
    assertSame(push, tool.world.applied());
    tool.world.release();
    assertWrench(tool.feels(), 0, 0, 10, 0, 0, 0);
    assertEquals(Wrench.ZERO, tool.world.applied());
  }

  @Test
  void appliedWrenchOutsideItsRangeIsRefused() {
    ContactWorld world = new ContactWorld(Scene.EMPTY);
    assertEquals(
        "applied fy is NaN, must be -10000 to 10000",
        assertThrows(
                IllegalArgumentException.class,
                () -> world.apply(new Wrench(0, Double.NaN, 0, 0, 0, 0)))
            .getMessage());
    assertEquals(
        "applied mz is 20000, must be -10000 to 10000",
        assertThrows(
                IllegalArgumentException.class, () -> world.apply(new Wrench(0, 0, 0, 0, 0, 2e4)))
            .getMessage());
  }
}
