package org.pendant.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

class BodyRailTest {
  private static final double M = Math.sqrt(0.5);
  private final RigidBodyWorld world =
      Bodies.upright(
          List.of(
              Bodies.cube("drawer", 0.1, Bodies.at(0, 0, 0.5), 0.3),
              Bodies.cube("part", 0.05, Bodies.at(0, 0, 0.575), 0.5),
              BodyDescription.kinematic(
                  "finger", new BodyShape.Sphere(0.01), Bodies.at(-1, 0, 0.5), Bodies.SMOOTH)));
  private final double[] at = new double[Transforms.SIZE];

  private static BodyRail.Line along(double frictionN, double dampingNSPerM) {
    return new BodyRail.Line(1, 0, 0, 0.3, frictionN, dampingNSPerM);
  }

  private void advance(double timeS) {
    for (int i = 0; i < Math.round(timeS / Bodies.STEP_S); i++) {
      world.advance(Bodies.STEP_S);
    }
  }

  @Test
  void aBodyOnALevelRailStaysThereUntilItIsPushed() {
    world.setPresent(1, false);
    BodyGuide rail = world.rail(0, along(5, 0));
    advance(2);
    world.pose(0, at);
    assertEquals(0, rail.place(), 1e-9);
    assertEquals(0.5, at[11], 1e-5);
    assertTrue(world.sleeping(0));
  }

  @Test
  void frictionStopsItWhereTheWorkOfItHasTakenItsEnergy() {
    world.setPresent(1, false);
    BodyGuide rail = world.rail(0, along(5, 0));
    world.throwBody(0, new double[] {1, 0, 0, 0, 0, 0});
    advance(2);
    assertEquals(1 / (2 * 5.0), rail.place(), 0.002);
  }

  @Test
  void dampingStopsItAfterItsMomentumByTheCoefficient() {
    world.setPresent(1, false);
    BodyGuide rail = world.rail(0, along(0, 10));
    world.throwBody(0, new double[] {1, 0, 0, 0, 0, 0});
    advance(5);
    assertEquals(0.1, rail.place(), 0.002);
  }

  @Test
  void itStopsAtBothEnds() {
    world.setPresent(1, false);
    BodyGuide rail = world.rail(0, along(0.5, 0));
    world.throwBody(0, new double[] {2, 0, 0, 0, 0, 0});
    advance(1);
    assertEquals(0.3, rail.place(), 1e-6);
    world.throwBody(0, new double[] {-2, 0, 0, 0, 0, 0});
    advance(1);
    assertEquals(0, rail.place(), 1e-6);
  }

  @Test
  void onASlopeItSlidesOnceItsWeightIsMoreThanFriction() {
    world.setPresent(1, false);
    double drawsN = Bodies.G * M;
    BodyRail.Line held = new BodyRail.Line(M, 0, -M, 0.3, 1.02 * drawsN, 0);
    BodyGuide rail = world.rail(0, held);
    advance(1);
    assertEquals(0, rail.place(), 1e-6);
    world.unguide(rail);
    rail = world.rail(0, new BodyRail.Line(M, 0, -M, 0.3, 0.98 * drawsN, 0));
    world.throwBody(0, new double[6]);
    advance(1);
    assertEquals(0.5 * 0.02 * drawsN, rail.place(), 0.01 * drawsN * 0.02);
  }

  @Test
  void aFingerPushesItAndFeelsTheFriction() {
    world.setPresent(1, false);
    BodyGuide rail = world.rail(0, along(8, 0));
    double[] pose12 = new double[Transforms.SIZE];
    double[] wrench6 = new double[6];
    double x = -0.08;
    for (int i = 0; i < 1500; i++) {
      x += 0.05 * Bodies.STEP_S;
      Transforms.of(new Pose(x, 0.03, 0.5, 0, 0, 0), pose12);
      world.moveKinematic(2, pose12, new double[] {0.05, 0, 0, 0, 0, 0});
      world.advance(Bodies.STEP_S);
    }
    world.wrench(2, wrench6);
    assertEquals(x + 0.06, rail.place(), 0.001);
    assertEquals(-8, wrench6[0], 0.16);
    world.pose(0, at);
    assertEquals(1, at[0], 1e-4, "it does not turn, though the finger is aside");
  }

  @Test
  void aMotorTakesItToTheEndAtItsSpeedAndHoldsItThere() {
    world.setPresent(1, false);
    BodyGuide rail = world.rail(0, along(50, 0));
    rail.drive(0.1);
    advance(1);
    assertEquals(0.1, rail.place(), 0.001);
    advance(3);
    assertEquals(0.3, rail.place(), 1e-6);
    rail.drive(0);
    advance(2);
    assertTrue(world.sleeping(0));
    rail.drive(-0.1);
    advance(1);
    assertEquals(0.2, rail.place(), 0.001);
  }

  @Test
  void itCarriesWhatLiesOnIt() {
    BodyGuide rail = world.rail(0, along(2, 0));
    world.throwBody(0, new double[] {0.3, 0, 0, 0, 0, 0});
    advance(1);
    double[] part = new double[Transforms.SIZE];
    world.pose(1, part);
    world.pose(0, at);
    assertTrue(rail.place() > 0.01);
    assertEquals(at[9], part[9], 0.02);
    assertEquals(0.575, part[11], 0.001);
  }

  @Test
  void onlyWhatIsFreeCanBeOnOneRail() {
    world.rail(0, along(1, 0));
    assertThrows(IllegalArgumentException.class, () -> world.rail(0, along(1, 0)));
    assertThrows(IllegalArgumentException.class, () -> world.rail(2, along(1, 0)));
  }
}
