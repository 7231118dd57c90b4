package org.pendant.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.cell.Bodies.G;
import static org.pendant.cell.Bodies.STEP_S;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.models.pose.Pose;

class RigidBodyWorldTest {
  @Test
  void aFreeFallKeepsItsEnergy() {
    RigidBodyWorld world =
        Bodies.upright(List.of(Bodies.cube("box", 0.1, Bodies.at(0, 0, 5), 0.3)));
    for (int i = 1; i <= 400; i++) {
      world.advance(STEP_S);
      double v = Bodies.velocity(world, 0)[2];
      double lost = G * (5 - Bodies.pose(world, 0)[11]);
      assertEquals(lost, v * v / 2, 0.005 * lost, "step " + i);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.4, 0.785, 1.3, 3})
  void aBoxSlidesDownASlopeWhenItIsSteeperThanFriction(double direction) {
    double angle = Math.atan(0.3);
    assertTrue(slidOnSlope(1.02 * angle, direction) > 0.002);
    assertTrue(slidOnSlope(0.98 * angle, direction) < 1e-4);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.4, 0.785, 1.3, 3})
  void aSlidingBoxStopsWhereCoulombSays(double direction) {
    RigidBodyWorld world =
        Bodies.upright(
            List.of(Bodies.floor(0.3, 0), Bodies.cube("box", 0.1, Bodies.at(0, 0, 0.0499), 0.3)));
    world.throwBody(1, new double[] {2 * Math.cos(direction), 2 * Math.sin(direction), 0, 0, 0, 0});
    Bodies.run(world, 1.5);
    double[] pose = Bodies.pose(world, 1);
    double expected = 2 * 2 / (2 * 0.3 * G);
    assertEquals(expected, Math.hypot(pose[9], pose[10]), 0.02 * expected);
  }

  @Test
  void aPushFromTheSideMovesWhatSlidesAlready() {
    // a gravity that leans to y by a third of friction: what holds at rest gives way in sliding
    RigidBodyWorld world =
        new RigidBodyWorld(
            List.of(Bodies.floor(0.3, 0), Bodies.cube("box", 0.1, Bodies.at(0, 0, 0.0499), 0.3)),
            0,
            0.1 * G,
            -G);
    world.throwBody(1, new double[] {2, 0, 0, 0, 0, 0});
    Bodies.run(world, 0.2);
    assertEquals(0.1 * G * 0.2, Bodies.velocity(world, 1)[1], 0.05 * 0.1 * G);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.3, 0.6, 0.9})
  void aBallBouncesWithItsRestitution(double restitution) {
    RigidBodyWorld world =
        Bodies.upright(
            List.of(
                Bodies.floor(0.3, 0),
                BodyDescription.free(
                    "ball",
                    new BodyShape.Sphere(0.05),
                    Bodies.at(0, 0, 0.5),
                    0.2,
                    new BodySurface(0.3, restitution, 40_000))));
    double before = 0;
    double after = 0;
    while (after <= 0) {
      before = after;
      world.advance(STEP_S);
      after = Bodies.velocity(world, 1)[2];
    }
    assertEquals(-restitution * before, after, 0.02 * after);
  }

  @Test
  void aKinematicPlateFeelsTheWeightOfABox() {
    RigidBodyWorld world =
        Bodies.upright(
            List.of(
                BodyDescription.kinematic(
                    "plate",
                    new BodyShape.Box(0.3, 0.3, 0.02),
                    Bodies.at(0, 0, 0.19),
                    BodySurface.DEFAULT),
                Bodies.cube("box", 0.1, Bodies.at(0.05, 0, 0.25), 0.3)));
    Bodies.run(world, 3);
    double[] wrench = new double[6];
    world.wrench(0, wrench);
    assertEquals(-9.82, wrench[2], 0.0982);
    assertEquals(0, wrench[0], 0.01);
    assertEquals(0.05 * 9.82, wrench[4], 0.01);
    assertFalse(world.sleeping(1));
  }

  @Test
  void aKinematicPlateCarriesABoxAlong() {
    RigidBodyWorld world =
        Bodies.upright(
            List.of(
                BodyDescription.kinematic(
                    "plate",
                    new BodyShape.Box(3, 0.3, 0.02),
                    Bodies.at(0, 0, 0.19),
                    BodySurface.DEFAULT),
                Bodies.cube("box", 0.1, Bodies.at(0, 0, 0.25), 0.3)));
    world.moveKinematic(
        0, new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0.19}, new double[] {0.1, 0, 0, 0, 0, 0});
    Bodies.run(world, 2);
    assertEquals(0.1, Bodies.velocity(world, 1)[0], 0.001);
  }

  @Test
  void aTowerOfTwelveBoxesStands() {
    double minutes = Double.parseDouble(System.getProperty("pendant.tower.minutes", "0.33"));
    RigidBodyWorld world = Bodies.tower(12);
    Bodies.run(world, 60 * minutes);
    for (int i = 1; i <= 12; i++) {
      double[] pose = Bodies.pose(world, i);
      assertEquals(0.1 * i - 0.05, pose[11], 0.003, "box " + i);
      assertEquals(0.002 * ((i - 1) % 3), pose[9], 0.003, "box " + i);
      assertTrue(world.sleeping(i));
    }
  }

  @Test
  void whatRestsSleepsUntilSomethingTouchesIt() {
    RigidBodyWorld world =
        Bodies.upright(
            List.of(
                Bodies.floor(0.5, 0),
                Bodies.cube("box", 0.1, Bodies.at(0, 0, 0.05), 0.5),
                Bodies.cube("other", 0.1, Bodies.at(1, 0, 0.05), 0.5)));
    Bodies.run(world, 1);
    assertTrue(world.sleeping(1) && world.sleeping(2));
    world.throwBody(2, new double[] {-4, 0, 0, 0, 0, 0});
    Bodies.run(world, 0.4);
    assertTrue(Bodies.pose(world, 1)[9] < -0.001);
  }

  /** How far a box slides in half a second on a slope that falls towards {@code direction}. */
  private static double slidOnSlope(double angle, double direction) {
    double along = G * Math.sin(angle);
    RigidBodyWorld world =
        new RigidBodyWorld(
            List.of(
                Bodies.floor(0.3, 0),
                Bodies.cube("box", 0.1, new Pose(0, 0, 0.0499, 0, 0, 0.2), 0.3)),
            along * Math.cos(direction),
            along * Math.sin(direction),
            -G * Math.cos(angle));
    Bodies.run(world, 0.5);
    double[] pose = Bodies.pose(world, 1);
    return Math.hypot(pose[9], pose[10]);
  }
}
