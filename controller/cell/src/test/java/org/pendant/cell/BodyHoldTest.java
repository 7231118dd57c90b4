package org.pendant.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.cell.Bodies.G;
import static org.pendant.cell.Bodies.STEP_S;

import java.util.List;
import org.junit.jupiter.api.Test;

class BodyHoldTest {
  private static final double[] STILL = new double[6];

  /** A cube of 1 kg whose middle is 3 cm below what holds it. */
  private final RigidBodyWorld world =
      Bodies.upright(List.of(Bodies.cube("box", 0.1, Bodies.at(0.02, 0, 0.97), 0.3)));

  private final double[] wrench = new double[6];

  private static HoldLimits fingers(double shearN) {
    return new HoldLimits(1, 1e9, 1e9, shearN, shearN * 0.0073, 2.2);
  }

  private BodyHold held(double shearN) {
    return world.hold(0, frame(0, 0, 1), fingers(shearN));
  }

  @Test
  void whatIsHeldFeelsAsHeavyAsItIs() {
    BodyHold hold = held(50);
    Bodies.run(world, 1);
    hold.wrench(wrench);
    assertEquals(-G, wrench[2], 0.001 * G);
    assertEquals(0.02 * G, wrench[4], 0.01 * G * 0.02);
    assertEquals(0.97, Bodies.pose(world, 0)[11], 3e-4);
  }

  @Test
  void whatIsHeldWeighsMoreWhereItIsAccelerated() {
    BodyHold hold = held(50);
    double worst = 0;
    for (int i = 1; i <= 250; i++) {
      double t = i * STEP_S;
      hold.move(frame(0, 0, 1 + t * t), new double[] {0, 0, 2 * t, 0, 0, 0});
      world.advance(STEP_S);
      hold.wrench(wrench);
      worst = i > 100 ? Math.max(worst, Math.abs(wrench[2] + G + 2)) : 0;
    }
    assertTrue(worst < 0.05, "off by " + worst + " N");
    assertEquals(0.97 + 0.25, Bodies.pose(world, 0)[11], 5e-3);
  }

  @Test
  void whatIsTooHeavySlipsAndFallsAsFrictionSays() {
    BodyHold hold = held(0.8 * G);
    Bodies.run(world, 0.5);
    hold.wrench(wrench);
    assertEquals(-0.8 * G, wrench[2], 0.02 * G);
    assertTrue(hold.overloadedSteps() > 200);
    assertEquals(0.97 - 0.5 * 0.2 * G * 0.25, Bodies.pose(world, 0)[11], 0.03);
  }

  @Test
  void whatIsReleasedFalls() {
    world.release(held(50));
    Bodies.run(world, 0.2);
    assertEquals(0.97 - 0.5 * G * 0.04, Bodies.pose(world, 0)[11], 1e-3);
  }

  @Test
  void aHeldBodyTurnsWithItsFrame() {
    BodyHold hold = held(50);
    for (int i = 1; i <= 500; i++) {
      double angle = i * STEP_S;
      double c = Math.cos(angle);
      double s = Math.sin(angle);
      hold.move(
          new double[] {c, -s, 0, s, c, 0, 0, 0, 1, 0, 0, 1}, new double[] {0, 0, 0, 0, 0, 1});
      world.advance(STEP_S);
    }
    double[] pose = Bodies.pose(world, 0);
    assertEquals(0.02 * Math.cos(1), pose[9], 3e-4);
    assertEquals(0.02 * Math.sin(1), pose[10], 3e-4);
    assertEquals(Math.sin(1), pose[3], 2e-3);
  }

  @Test
  void whatHangsOnItsEdgeSwingsDown() {
    RigidBodyWorld bar =
        Bodies.upright(
            List.of(
                BodyDescription.free(
                    "bar",
                    new BodyShape.Box(0.4, 0.02, 0.02),
                    Bodies.at(0.15, 0, 1),
                    1,
                    BodySurface.DEFAULT)));
    BodyHold hold = bar.hold(0, frame(0, 0, 1), fingers(50));
    hold.move(frame(0, 0, 1), STILL);
    Bodies.run(bar, 5);
    double[] pose = Bodies.pose(bar, 0);
    // half a Nm of friction against 0.15 m of lever
    assertTrue(pose[11] < 0.9, "middle at " + pose[11]);
    assertEquals(0.15, Math.hypot(pose[9], pose[11] - 1), 0.005);
  }

  @Test
  void aHeldBodyPressesOnWhatItIsPutOn() {
    RigidBodyWorld table =
        Bodies.upright(
            List.of(Bodies.floor(0.3, 0), Bodies.cube("box", 0.1, Bodies.at(0, 0, 0.05), 0.3)));
    BodyHold hold = table.hold(1, frame(0, 0, 0.1), fingers(500));
    hold.move(frame(0, 0, 0.0995), STILL);
    Bodies.run(table, 1);
    hold.wrench(wrench);
    assertEquals(0.5e-3 * 1e5, wrench[2] + G, 10);
  }

  private static double[] frame(double x, double y, double z) {
    return new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1, x, y, z};
  }
}
