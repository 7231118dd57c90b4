package org.pendant.motion.servo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.PlanningException;

@Tag("slow")
class ServoCTest {
  private final Rig rig = new Rig();

  private static Pose beside(Pose from, double... change) {
    Pose moved = Poses.add(new Pose(0, 0, 0, change[3], change[4], change[5]), from);
    return new Pose(
        from.x() + change[0],
        from.y() + change[1],
        from.z() + change[2],
        moved.rx(),
        moved.ry(),
        moved.rz());
  }

  private MotionPlan to(Pose goal, double a, double v, double r) {
    return rig.servoing.servoC(goal, Rig.TCP, a, v, r);
  }

  private void assertAt(Pose goal) {
    assertEquals(0, Poses.pointDistance(goal, rig.tcp()), 1e-9);
    assertEquals(0, Poses.rotationAngle(goal, rig.tcp()), 1e-8);
    assertEquals(Joints.ZERO, rig.control.speedRadPerS());
  }

  @Test
  void fromRestItGoesStraightAndStopsInThePose() throws PlanningException {
    Pose start = rig.tcp();
    Pose goal = beside(start, 0.05, 0.08, 0.02, 0, 0, 0.2);
    rig.control.continueWith(to(goal, 0.5, 0.1, 0));
    double length = Poses.pointDistance(start, goal);
    while (rig.control.moving()) {
      rig.step();
      double way = Poses.pointDistance(start, rig.tcp());
      assertEquals(length, way + Poses.pointDistance(rig.tcp(), goal), 1e-9);
    }
    assertAt(goal);
  }

  @Test
  void continuesAtTheRadiusAndTurnsOnACircleToTheNextPose() throws PlanningException {
    Pose start = rig.tcp();
    Pose corner = beside(start, 0, 0.1, 0, 0, 0, 0);
    rig.run(to(corner, 1, 0.1, 0.02));
    assertEquals(0.02, Poses.pointDistance(corner, rig.tcp()), 3e-4);
    assertEquals(0.1, rig.twist()[1], 1e-6);
    Pose begin = rig.tcp();
    Pose next = beside(begin, 0.04, 0.04, 0, 0, 0, 0);
    // tangent to y through a point 45 degrees ahead: a quarter of a circle of 40 mm
    rig.control.continueWith(to(next, 1, 0.1, 0));
    double slowest = 1;
    while (Poses.pointDistance(next, rig.tcp()) > 0.015) {
      rig.step();
      double radius = Math.hypot(rig.tcp().x() - begin.x() - 0.04, rig.tcp().y() - begin.y());
      assertEquals(0.04, radius, 1e-6);
      double[] twist = rig.twist();
      slowest = Math.min(slowest, Math.hypot(twist[0], twist[1]));
    }
    assertEquals(0.1, slowest, 1e-6, "constant speed");
    rig.untilRest();
    assertAt(next);
  }

  @Test
  void aloneItEndsInItsPose() throws PlanningException {
    Pose goal = beside(rig.tcp(), 0, 0.1, 0, 0, 0, 0);
    rig.run(to(goal, 1, 0.1, 0.03));
    rig.untilRest();
    assertAt(goal);
    assertFalse(rig.control.moving());
  }

  @Test
  void aPoseBehindIsReachedAfterAStop() throws PlanningException {
    Pose start = rig.tcp();
    rig.run(
        rig.servoing.speedL(
            Rig.TCP, new double[] {0, 0.1, 0, 0, 0, 0.1}, 0.5, 2, OptionalDouble.empty()));
    rig.run(to(start, 0.5, 0.1, 0));
    assertAt(start);
  }

  @Test
  void aPureTurnTakesTheTimeItNeeds() throws PlanningException {
    Pose goal = beside(rig.tcp(), 0, 0, 0, 0, 0.5, 0);
    int frames = rig.run(to(goal, 1, 0.25, 0));
    assertEquals(Math.max(1.5 * 0.5 / 1, Math.sqrt(6 * 0.5 / 4)) / Rig.FRAME_S, frames, 2);
    assertAt(goal);
  }

  @Test
  void aPoseThatIsReachedAlreadyTakesAFrame() throws PlanningException {
    assertEquals(1, rig.run(to(rig.tcp(), 1, 0.25, 0)));
    assertEquals(1, rig.run(to(rig.tcp(), 1, 0.25, 0.1)));
    assertAt(rig.tcp());
  }

  @Test
  void randomChainsAreSmoothAndEndInTheLastPose() throws PlanningException {
    SplittableRandom random = new SplittableRandom(11);
    Pose middle = rig.tcp();
    for (int each = 0; each < 60; each++) {
      Pose goal = middle;
      for (int i = 0; i < 8; i++) {
        double[] change = new double[Joints.COUNT];
        for (int k = 0; k < change.length; k++) {
          change[k] = (k < 3 ? 0.06 : 0.3) * (2 * random.nextDouble() - 1);
        }
        goal = beside(middle, change);
        rig.run(to(goal, 0.8, 0.12, i == 7 ? 0 : 0.03 * random.nextDouble()));
      }
      rig.untilRest();
      assertAt(goal);
    }
    assertTrue(rig.largestAcceleration < 40, "no jump of a speed: " + rig.largestAcceleration);
  }
}
