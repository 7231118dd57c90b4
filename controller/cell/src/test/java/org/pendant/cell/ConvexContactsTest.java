package org.pendant.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.models.pose.Pose;

/** Cylinders and capsules come to rest on flat things, and flat things on them. */
class ConvexContactsTest {
  private static final BodyDescription TABLE =
      BodyDescription.fixed(
          "table", new BodyShape.Box(0.3, 0.15, 0.1), Bodies.at(0, 0, -0.05), BodySurface.DEFAULT);
  private static final BodyShape BAR = new BodyShape.Cylinder(0.02, 0.06);
  private static final BodyShape DISC = new BodyShape.Cylinder(0.035, 0.02);
  private static final BodyShape PILL = new BodyShape.Capsule(0.02, 0.06);

  private static BodyDescription part(String name, BodyShape shape, Pose pose) {
    return BodyDescription.free(name, shape, pose, 0.6, BodySurface.DEFAULT);
  }

  /** Drops bodies a little, and says how far the last one is from where it began after 4 s. */
  private static double[] rest(BodyDescription... parts) {
    List<BodyDescription> all = new ArrayList<>(List.of(TABLE));
    all.addAll(List.of(parts));
    RigidBodyWorld world = Bodies.upright(all);
    Bodies.run(world, 4);
    assertTrue(world.sleeping(parts.length), "it rests");
    return Bodies.pose(world, parts.length);
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "0.002, 0.3", "0.004, 1.1", "0.006, 2"})
  void aCylinderStandsOnABox(double tilt, double yaw) {
    double[] pose = rest(part("bar", BAR, new Pose(0.01, 0.02, 0.0315, tilt, 0, yaw)));
    assertEquals(0.03, pose[11], 2e-4);
    assertEquals(0.01, pose[9], 5e-4);
    assertEquals(0.02, pose[10], 5e-4);
  }

  @Test
  void aCylinderLiesOnABox() {
    double[] pose = rest(part("bar", BAR, new Pose(0, 0, 0.0205, Math.PI / 2, 0, 0)));
    assertEquals(0.02, pose[11], 2e-4);
    assertEquals(0, pose[9], 5e-4);
  }

  @Test
  void aCapsuleLiesOnADisc() {
    double[] pose =
        rest(
            part("disc", DISC, new Pose(0, 0, 0.0101, 0, 0, 0.3)),
            part("pill", PILL, new Pose(0, 0, 0.0405, Math.PI / 2, 0, 0)));
    assertEquals(0.04, pose[11], 3e-4);
    assertEquals(0, pose[9], 5e-4);
  }

  @Test
  void aBoxStandsOnADisc() {
    double[] pose =
        rest(
            part("disc", DISC, new Pose(0, 0, 0.0101, 0, 0, 0.3)),
            part("box", new BodyShape.Box(0.05, 0.05, 0.05), new Pose(0.004, 0, 0.0455, 0, 0, 1)));
    assertEquals(0.045, pose[11], 3e-4);
    assertEquals(0.004, pose[9], 5e-4);
  }

  @Test
  void aDiscThatReachesTooFarOverAnEdgeFalls() {
    RigidBodyWorld world =
        Bodies.upright(List.of(TABLE, part("disc", DISC, new Pose(0, 0.08, 0.0101, 0, 0, 0))));
    Bodies.run(world, 1);
    assertTrue(Bodies.pose(world, 1)[11] < -0.5);
  }

  @Test
  void aCylinderRollsDownASlope() {
    double slope = 0.1;
    RigidBodyWorld world =
        new RigidBodyWorld(
            List.of(TABLE, part("bar", BAR, new Pose(-0.1, 0, 0.0199, Math.PI / 2, 0, 0))),
            Bodies.G * Math.sin(slope),
            0,
            -Bodies.G * Math.cos(slope));
    Bodies.run(world, 0.5);
    // a rolling cylinder is slower than a sliding one by its inertia
    double way = 0.5 * Bodies.G * Math.sin(slope) / 1.5 * 0.25;
    assertEquals(way, Bodies.pose(world, 1)[9] + 0.1, 0.05 * way);
  }

  /** Lets a world go on whose bodies are never left to sleep; how far the last one has got, m. */
  private static double driftM(RigidBodyWorld world, double timeS) {
    int last = world.size() - 1;
    double[] before = Bodies.pose(world, last);
    double[] rest = new double[6];
    for (int step = 0; step < timeS / Bodies.STEP_S; step++) {
      if (step % 200 == 0) {
        world.throwBody(last, rest);
      }
      world.advance(Bodies.STEP_S);
    }
    double[] after = Bodies.pose(world, last);
    return Math.hypot(after[9] - before[9], after[10] - before[10]);
  }

  @ParameterizedTest
  @CsvSource({"2, 0", "2, 0.0005", "8, 0", "8, 0.0005"})
  void cylindersThatStandOnOneAnotherStayThere(int cylinders, double askewM) {
    double minutes = Double.parseDouble(System.getProperty("pendant.tower.minutes", "0.1"));
    List<BodyDescription> all = new ArrayList<>(List.of(TABLE));
    for (int i = 0; i < cylinders; i++) {
      Pose pose = new Pose(askewM * (i % 2), askewM * (i % 3), 0.01 + 0.02 * i, 0, 0, 0.7 * i);
      all.add(part("disc " + i, DISC, pose));
    }
    RigidBodyWorld world = Bodies.upright(all);
    Bodies.run(world, 1);
    assertEquals(0, driftM(world, 60 * minutes), 2e-4);
    assertEquals(0.02 * cylinders - 0.01, Bodies.pose(world, cylinders)[11], 1e-4 * cylinders);
  }

  @Test
  void aCylinderThatLiesInTheGapOfTwoOthersStaysThere() {
    double minutes = Double.parseDouble(System.getProperty("pendant.tower.minutes", "0.1"));
    double up = 0.02 + 0.04 * Math.sqrt(0.75);
    RigidBodyWorld world =
        Bodies.upright(
            List.of(
                TABLE,
                BodyDescription.fixed(
                    "left", BAR, new Pose(-0.0201, 0, 0.02, Math.PI / 2, 0, 0), TABLE.surface()),
                BodyDescription.fixed(
                    "right", BAR, new Pose(0.0201, 0, 0.02, Math.PI / 2, 0, 0), TABLE.surface()),
                part("bar", BAR, new Pose(0, 0, up, Math.PI / 2, 0, 0))));
    Bodies.run(world, 1);
    assertEquals(0, driftM(world, 60 * minutes), 2e-4);
  }

  @Test
  void aCylinderThatLiesAcrossTwoOthersStaysThere() {
    double minutes = Double.parseDouble(System.getProperty("pendant.tower.minutes", "0.1"));
    RigidBodyWorld world =
        Bodies.upright(
            List.of(
                TABLE,
                BodyDescription.fixed(
                    "left", BAR, new Pose(-0.022, 0, 0.02, Math.PI / 2, 0, 0), TABLE.surface()),
                BodyDescription.fixed(
                    "right", BAR, new Pose(0.022, 0, 0.02, Math.PI / 2, 0, 0), TABLE.surface()),
                part("bar", BAR, new Pose(0, 0, 0.0599, 0, Math.PI / 2, 0))));
    Bodies.run(world, 1);
    assertEquals(0, driftM(world, 60 * minutes), 2e-4);
  }
}
