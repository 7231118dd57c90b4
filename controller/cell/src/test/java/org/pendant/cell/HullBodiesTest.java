package org.pendant.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.cell.Bodies.G;
import static org.pendant.cell.Bodies.STEP_S;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.models.mesh.ConvexHull;
import org.pendant.models.mesh.MeshException;
import org.pendant.models.pose.Pose;

/** Hulls fall, rest, slide and stack as other bodies do. */
class HullBodiesTest {
  private static final BodySurface WOOD = new BodySurface(0.3, 0, 40_000);

  /** A cube of 0.1 m, as a hull. */
  private static final BodyShape CUBE =
      new BodyShape.Hull(ConvexHull.block(0.1, 0.1, 0.1), 0.01 / 6, 0.01 / 6, 0.01 / 6);

  private static BodyDescription hull(String name, BodyShape shape, Pose pose) {
    return BodyDescription.free(name, shape, pose, 1, WOOD);
  }

  private static BodyShape block(double x, double y, double z) {
    return new BodyShape.Hull(
        ConvexHull.block(x, y, z),
        (y * y + z * z) / 12,
        (z * z + x * x) / 12,
        (x * x + y * y) / 12);
  }

  private static RigidBodyWorld onFloor(BodyDescription... bodies) {
    List<BodyDescription> all = new ArrayList<>(List.of(Bodies.floor(0.3, 0)));
    all.addAll(List.of(bodies));
    return Bodies.upright(all);
  }

  private static void requireRest(RigidBodyWorld world, int body, double z) {
    double[] pose = Bodies.pose(world, body);
    assertEquals(z, pose[11], 5e-4, world.description(body).name());
    assertTrue(world.sleeping(body), world.description(body).name() + " rests");
  }

  @Test
  void aFreeFallKeepsItsEnergyWhileItTumbles() {
    BodyShape bar = block(0.3, 0.1, 0.05);
    RigidBodyWorld world = Bodies.upright(List.of(hull("bar", bar, Bodies.at(0, 0, 5))));
    world.throwBody(0, new double[] {0.2, 0, 0, 2, 3, 1});
    double before = energy(world, 0, (BodyShape.Hull) bar);
    for (int i = 1; i <= 400; i++) {
      world.advance(STEP_S);
      double fallen = G * (5 - Bodies.pose(world, 0)[11]);
      assertEquals(before, energy(world, 0, (BodyShape.Hull) bar), 0.005 * Math.max(fallen, 1));
    }
  }

  /** For each kg, J: of motion and of height above 0. */
  private static double energy(RigidBodyWorld world, int body, BodyShape.Hull shape) {
    double[] pose = Bodies.pose(world, body);
    double[] v = Bodies.velocity(world, body);
    double sum = G * (pose[11] - 5) + (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2;
    double[] moments = {shape.xM2(), shape.yM2(), shape.zM2()};
    for (int k = 0; k < 3; k++) {
      double rate = pose[k] * v[3] + pose[3 + k] * v[4] + pose[6 + k] * v[5];
      sum += moments[k] * rate * rate / 2;
    }
    return sum;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.4, 0.785, 1.3, 3})
  void slidesDownASlopeWhenItIsSteeperThanFriction(double direction) {
    double angle = Math.atan(0.3);
    assertTrue(slidOnSlope(1.02 * angle, direction) > 0.002);
    assertTrue(slidOnSlope(0.98 * angle, direction) < 1e-4);
  }

  private static double slidOnSlope(double angle, double direction) {
    double along = G * Math.sin(angle);
    RigidBodyWorld world =
        new RigidBodyWorld(
            List.of(Bodies.floor(0.3, 0), hull("cube", CUBE, new Pose(0, 0, 0.0499, 0, 0, 0.2))),
            along * Math.cos(direction),
            along * Math.sin(direction),
            -G * Math.cos(angle));
    Bodies.run(world, 0.5);
    double[] pose = Bodies.pose(world, 1);
    return Math.hypot(pose[9], pose[10]);
  }

  @Test
  void aSlidingOneStopsWhereCoulombSays() {
    RigidBodyWorld world = onFloor(hull("cube", CUBE, Bodies.at(0, 0, 0.0499)));
    world.throwBody(1, new double[] {2, 0, 0, 0, 0, 0});
    Bodies.run(world, 1.5);
    double expected = 2 * 2 / (2 * 0.3 * G);
    assertEquals(expected, Bodies.pose(world, 1)[9], 0.02 * expected);
  }

  @Test
  void itRestsOnEverythingThatStandsStill() {
    BodyShape plate = new BodyShape.Box(0.5, 0.5, 0.1);
    BodyShape drum = new BodyShape.Cylinder(0.2, 0.1);
    RigidBodyWorld world =
        Bodies.upright(
            List.of(
                Bodies.floor(0.3, 0),
                BodyDescription.fixed("plate", plate, Bodies.at(1, 0, 0.05), WOOD),
                BodyDescription.fixed("drum", drum, Bodies.at(2, 0, 0.05), WOOD),
                BodyDescription.fixed(
                    "mesh",
                    new BodyShape.Faces(ConvexHull.block(0.5, 0.5, 0.1).surface()),
                    Bodies.at(3, 0, 0.05),
                    WOOD),
                hull("on floor", CUBE, new Pose(0, 0, 0.06, 0.02, 0.03, 0.4)),
                hull("on plate", CUBE, new Pose(1, 0, 0.16, 0.02, 0.03, 0.4)),
                hull("on drum", CUBE, new Pose(2, 0, 0.16, 0.02, 0.03, 0.4)),
                hull("on mesh", CUBE, new Pose(3, 0, 0.16, 0.02, 0.03, 0.4))));
    Bodies.run(world, 3);
    requireRest(world, 4, 0.05);
    for (int body = 5; body < 8; body++) {
      requireRest(world, body, 0.15);
    }
  }

  @Test
  void everythingRestsOnIt() {
    BodyShape slab = block(0.3, 0.3, 0.1);
    BodyShape[] tops = {
      new BodyShape.Box(0.1, 0.1, 0.1),
      new BodyShape.Sphere(0.05),
      new BodyShape.Cylinder(0.05, 0.1),
      new BodyShape.Capsule(0.05, 0.1),
      CUBE
    };
    List<BodyDescription> all = new ArrayList<>(List.of(Bodies.floor(0.3, 0)));
    for (int i = 0; i < tops.length; i++) {
      all.add(hull("slab " + i, slab, Bodies.at(i, 0, 0.05)));
      double roll = tops[i] instanceof BodyShape.Capsule ? Math.PI / 2 : 0;
      all.add(hull("top " + i, tops[i], new Pose(i, 0, 0.151, roll, 0, 0)));
    }
    RigidBodyWorld world = Bodies.upright(all);
    Bodies.run(world, 4);
    for (int i = 0; i < tops.length; i++) {
      requireRest(world, 1 + 2 * i, 0.05);
      requireRest(world, 2 + 2 * i, 0.15);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.3, 0.35, 0.4})
  void aTowerOfEightStands(double yaw) {
    List<BodyDescription> bodies = new ArrayList<>(List.of(Bodies.floor(0.5, 0)));
    for (int i = 0; i < 8; i++) {
      Pose pose = new Pose(0.002 * (i % 3), -0.002 * (i % 2), 0.05 + 0.1 * i, 0, 0, yaw * i);
      bodies.add(hull("cube " + i, CUBE, pose));
    }
    RigidBodyWorld world = Bodies.upright(bodies);
    Bodies.run(world, 2);
    for (int i = 1; i <= 8; i++) {
      assertEquals(0.1 * i - 0.05, Bodies.pose(world, i)[11], 0.003, "cube " + i);
      assertEquals(0.002 * ((i - 1) % 3), Bodies.pose(world, i)[9], 4e-4, "cube " + i);
      assertTrue(world.sleeping(i), "cube " + i);
    }
  }

  @Test
  void barsThatCrossHoldEachOtherInTheMiddle() {
    // no corner of one is in the other
    RigidBodyWorld world =
        onFloor(
            hull("lower", block(0.4, 0.05, 0.05), Bodies.at(0, 0, 0.025)),
            hull("upper", block(0.05, 0.4, 0.05), Bodies.at(0, 0, 0.08)));
    Bodies.run(world, 2);
    requireRest(world, 2, 0.075);
  }

  @Test
  void edgesThatCrossHoldEachOther() {
    // two bars that stand on edge, the upper one across the lower one, which is fixed
    double edge = 0.05 * Math.sqrt(0.5);
    RigidBodyWorld world =
        Bodies.upright(
            List.of(
                BodyDescription.kinematic(
                    "lower", block(0.4, 0.05, 0.05), new Pose(0, 0, 0.1, Math.PI / 4, 0, 0), WOOD),
                hull(
                    "upper",
                    block(0.05, 0.4, 0.05),
                    new Pose(0, 0, 0.1 + 2 * edge + 0.001, 0, Math.PI / 4, 0))));
    Bodies.run(world, 0.06);
    double[] wrench = new double[6];
    double most = 0;
    for (int i = 0; i < 50; i++) {
      world.advance(STEP_S);
      world.wrench(0, wrench);
      most = Math.min(most, wrench[2]);
    }
    assertTrue(Bodies.pose(world, 1)[11] > 0.1 + 2 * edge - 0.002, "it lies on the edge");
    assertEquals(-G, most, 0.5 * G);
  }

  @Test
  void aRollingOneOfManySidesGoesOn() throws MeshException {
    double r = 0.05;
    BodyShape wheel =
        new BodyShape.Hull(
            ConvexHull.prism(48, r, 0.04),
            (3 * r * r + 0.0016) / 12,
            (3 * r * r + 0.0016) / 12,
            r * r / 2);
    RigidBodyWorld world = onFloor(hull("wheel", wheel, new Pose(0, 0, r, Math.PI / 2, 0, 0)));
    world.throwBody(1, new double[] {0.5, 0, 0, 0, 0.5 / r, 0});
    Bodies.run(world, 1);
    assertTrue(Bodies.pose(world, 1)[9] > 0.4);
    assertEquals(0, Bodies.pose(world, 1)[10], 0.005);
  }

  @Test
  void aHeapOfRandomOnesComesToRestAboveTheFloorAndIsTheSameEveryTime() throws MeshException {
    RigidBodyWorld one = heap();
    RigidBodyWorld again = heap();
    Bodies.run(one, 4);
    Bodies.run(again, 4);
    assertEquals(Bodies.bits(one), Bodies.bits(again));
    for (int i = 1; i < one.size(); i++) {
      double z = Bodies.pose(one, i)[11];
      assertTrue(z > 0.005 && z < 0.3, one.description(i).name() + " is at " + z);
      double[] v = Bodies.velocity(one, i);
      assertTrue(Math.hypot(v[0], v[1]) < 0.05, one.description(i).name() + " is at rest");
    }
  }

  private static RigidBodyWorld heap() throws MeshException {
    Random random = new Random(11);
    List<BodyDescription> all = new ArrayList<>(List.of(Bodies.floor(0.5, 0)));
    for (int i = 0; i < 12; i++) {
      double[] points = new double[60];
      for (int k = 0; k < points.length; k++) {
        points[k] = 0.06 * (random.nextDouble() - 0.5);
      }
      BodyShape shape = new BodyShape.Hull(ConvexHull.of(points), 6e-4, 5e-4, 4e-4);
      all.add(
          BodyDescription.free(
              "stone " + i,
              shape,
              new Pose(0.05 * (i % 2), 0.04 * (i % 3), 0.1 + 0.1 * i, 0.3 * i, 0.2, 0),
              0.4,
              new BodySurface(0.5, 0, 40_000)));
    }
    return Bodies.upright(all);
  }

  @Test
  void raysAndSensorsSeeItsFacesAndNotTheBallAroundIt() {
    BodyShape slab = block(0.4, 0.4, 0.02);
    RigidBodyWorld world = Bodies.upright(List.of(hull("slab", slab, Bodies.at(0, 0, 0.5))));
    double[] up = {0, 0, 1};
    assertEquals(0.29, world.enters(0, new double[] {0.1, 0.1, 0.2}, up, 1), 1e-9);
    assertEquals(
        Double.POSITIVE_INFINITY, world.enters(0, new double[] {0.21, 0, 0.2}, up, 1), "beside");
    assertEquals(
        Double.POSITIVE_INFINITY, world.enters(0, new double[] {0, 0, 0.5}, up, 1), "inside");
    assertEquals(
        Double.POSITIVE_INFINITY, world.enters(0, new double[] {0, 0, 0.2}, up, 0.2), "too short");
    double[] left = {-1, 0, 0.48};
    double[] right = {1, 0, 0.48};
    assertFalse(world.watchLine(left, right, 0.005).sees());
    assertTrue(world.watchLine(left, right, 0.015).sees());
    assertFalse(world.watchBox(new double[] {0, 0, 0.4}, new double[] {0.1, 0.1, 0.48}).sees());
    assertTrue(world.watchBox(new double[] {0, 0, 0.4}, new double[] {0.1, 0.1, 0.495}).sees());
  }

  @Test
  void whatCannotBeABodyIsRefused() {
    assertEquals(
        "length is 5.0E-4 m, must be 0.001 to 10 m",
        assertThrows(IllegalArgumentException.class, () -> block(0.1, 0.1, 0.0005)).getMessage());
    ConvexHull beside =
        ConvexHull.block(0.1, 0.1, 0.1)
            .seenFrom(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06, 0, 0});
    assertEquals(
        "its centre of gravity is not within its hull: its surface goes through itself",
        assertThrows(IllegalArgumentException.class, () -> new BodyShape.Hull(beside, 1, 1, 1))
            .getMessage());
  }
}
