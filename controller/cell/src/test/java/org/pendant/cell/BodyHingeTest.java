package org.pendant.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class BodyHingeTest {
  /** Of a leaf of 3 kg that is 0.4 m wide and 0.02 m thick, about the line at its edge, kg m^2. */
  private static final double INERTIA = 3 * (0.4 * 0.4 + 0.02 * 0.02) / 12 + 3 * 0.2 * 0.2;

  private static BodyDescription leaf() {
    return BodyDescription.free(
        "leaf",
        new BodyShape.Box(0.4, 0.02, 0.5),
        Bodies.at(0.2, 0, 1),
        3,
        new BodySurface(0.3, 0, 40_000));
  }

  private static BodyHinge.Axis upright(double frictionNm) {
    return new BodyHinge.Axis(0, 0, 0, 0, 0, 1, 1.5, frictionNm);
  }

  private final RigidBodyWorld world =
      Bodies.upright(
          List.of(
              leaf(),
              BodyDescription.fixed(
                  "post",
                  new BodyShape.Cylinder(0.05, 2),
                  Bodies.at(0.15, 0.3, 1),
                  Bodies.SMOOTH)));

  private BodyHingeTest() {
    world.setPresent(1, false);
  }

  @Test
  void aLeafOnAnUprightHingeStaysThereUntilItIsPushed() {
    BodyGuide hinge = world.hinge(0, upright(1));
    Bodies.run(world, 2);
    assertEquals(0, hinge.place(), 1e-9);
    assertEquals(1, Bodies.pose(world, 0)[11], 1e-5);
    assertTrue(world.sleeping(0));
  }

  @Test
  void frictionStopsItWhereTheWorkOfItHasTakenItsEnergy() {
    BodyGuide hinge = world.hinge(0, upright(1));
    world.throwBody(0, new double[] {0, 0.4, 0, 0, 0, 2});
    Bodies.run(world, 2);
    assertEquals(INERTIA * 2 * 2 / 2, hinge.place(), 0.005);
  }

  @Test
  void itStaysOnItsLineWhileItTurns() {
    BodyGuide hinge = world.hinge(0, upright(0));
    world.throwBody(0, new double[] {0, 0.2, 0, 0, 0, 1});
    Bodies.run(world, 1);
    double[] pose = Bodies.pose(world, 0);
    assertEquals(1, hinge.place(), 1e-3);
    assertEquals(0.2 * Math.cos(hinge.place()), pose[9], 1e-4);
    assertEquals(0.2 * Math.sin(hinge.place()), pose[10], 1e-4);
    assertEquals(1, pose[11], 1e-5);
    assertEquals(1, pose[8], 1e-9);
  }

  @Test
  void itStopsAtBothEnds() {
    BodyGuide hinge = world.hinge(0, upright(1));
    world.throwBody(0, new double[] {0, 1, 0, 0, 0, 5});
    Bodies.run(world, 1);
    assertEquals(1.5, hinge.place(), 1e-5);
    hinge.drive(-5);
    Bodies.run(world, 2);
    assertEquals(0, hinge.place(), 1e-5);
  }

  @Test
  void aLidFallsShutAsAPendulumDoes() {
    BodyGuide lid = world.hinge(0, new BodyHinge.Axis(0, 0, 1, 0, 1, 0, 1.5, 0));
    // upright about y: x goes down
    Bodies.run(world, 0.2);
    double inertia = 3 * (0.4 * 0.4 + 0.5 * 0.5) / 12 + 3 * 0.2 * 0.2;
    double begins = 3 * Bodies.G * 0.2 / inertia;
    assertEquals(begins * 0.2 * 0.2 / 2, lid.place(), 0.03 * lid.place());
    Bodies.run(world, 2);
    assertEquals(1.5, lid.place(), 1e-4);
  }

  @Test
  void aMotorTakesItAtItsSpeedAndIsAsStrongAsItsFriction() {
    BodyGuide hinge = world.hinge(0, upright(4));
    hinge.drive(0.5);
    Bodies.run(world, 2);
    assertEquals(1, hinge.place(), 0.01);
  }

  @Test
  void whatIsInItsWayHoldsIt() {
    world.setPresent(1, true);
    BodyGuide hinge = world.hinge(0, upright(4));
    hinge.drive(0.5);
    Bodies.run(world, 4);
    double atPost = Math.atan2(0.3, 0.15) - Math.asin(0.06 / Math.hypot(0.3, 0.15));
    assertEquals(atPost, hinge.place(), 0.01);
    hinge.drive(0.5);
    Bodies.run(world, 0.1);
    double force = world.contacts().stream().mapToDouble(BodyContact::forceN).sum();
    assertEquals(4 / Math.sqrt(0.3 * 0.3 + 0.15 * 0.15 - 0.06 * 0.06), force, 0.3);
  }

  @Test
  void onlyWhatIsFreeCanBeGuidedOnce() {
    world.hinge(0, upright(1));
    assertThrows(IllegalArgumentException.class, () -> world.hinge(0, upright(1)));
    assertThrows(IllegalArgumentException.class, () -> world.hinge(1, upright(1)));
  }
}
