package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

final class ArcPathTest {
  private static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  private static final Pose TCP = new Pose(0, 0, 0.1, 0, 0, 0);

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final Pose home = forward.tcpPose(READY, TCP);

  private Pose shifted(double x, double y, double z) {
    return new Pose(home.x() + x, home.y() + y, home.z() + z, home.rx(), home.ry(), home.rz());
  }

  private MotionPath arc(Pose via, Pose goal, boolean fixed) throws PlanningException {
    return new ArcRoute(arm, via, goal, fixed, TCP, PathLimits.UNLIMITED).from(READY, home);
  }

  private Pose at(MotionPath path, double at, MotionSample sample) {
    assertTrue(path.sample(at, 1, 0, sample).isEmpty());
    return forward.tcpPose(sample.positionRad(), TCP);
  }

  @Test
  void staysOnTheCircleThroughThreePointsWithinANanometre() throws PlanningException {
    SplittableRandom random = new SplittableRandom(1);
    for (int each = 0; each < 100; each++) {
      double radius = random.nextDouble(0.02, 0.15);
      double turn = random.nextDouble(0.5, 5.5);
      double tilt = random.nextDouble(-1, 1);
      double[][] points = new double[3][];
      for (int i = 0; i < 3; i++) {
        double angle = i == 1 ? turn * random.nextDouble(0.2, 0.8) : turn * i / 2;
        double x = radius * Math.sin(angle);
        double y = radius * (1 - Math.cos(angle));
        points[i] = new double[] {x, y * Math.cos(tilt), y * Math.sin(tilt)};
      }
      Pose centre = shifted(0, radius * Math.cos(tilt), radius * Math.sin(tilt));
      Pose goal = shifted(points[2][0], points[2][1], points[2][2]);
      MotionPath path = arc(shifted(points[1][0], points[1][1], points[1][2]), goal, false);
      String input = "circle " + each;
      assertEquals(radius * turn, path.length(), 1e-9, input);
      MotionSample sample = new MotionSample();
      for (int k = 0; k <= 50; k++) {
        Pose now = at(path, path.length() * k / 50, sample);
        assertEquals(radius, Poses.pointDistance(centre, now), 1e-9, input);
      }
      assertEquals(0, Poses.distance(goal, at(path, path.length(), sample)), 1e-9, input);
    }
  }

  @Test
  void turnsTheToolWithTheTangentInMode1() throws PlanningException {
    MotionPath path = arc(shifted(0.08, 0.08, 0), shifted(0, 0.16, 0), true);
    MotionSample sample = new MotionSample();
    Pose end = at(path, path.length(), sample);
    assertEquals(Math.PI, Poses.rotationAngle(home, end), 1e-9);
    Pose middle = at(path, 0.5 * path.length(), sample);
    assertEquals(Math.PI / 2, Poses.rotationAngle(home, middle), 1e-9);
    assertEquals(0.16 * Math.PI / 2, path.length(), 1e-12);
    assertEquals(0, Poses.distance(path.waypoint(), end), 1e-9);
  }

  @Test
  void keepsTheJointsOnTheirTurnOverAWholeCircle() throws PlanningException {
    double turn = 6;
    Pose via = shifted(0.05 * Math.sin(3), 0.05 * (1 - Math.cos(3)), 0);
    Pose goal = shifted(0.05 * Math.sin(turn), 0.05 * (1 - Math.cos(turn)), 0);
    MotionPath path = arc(via, goal, true);
    MotionSample sample = new MotionSample();
    at(path, path.length(), sample);
    Joints end = sample.positionRad();
    assertTrue(Math.abs(end.get(5)) > 5, "joint 5 ends at " + end.get(5));
    assertEquals(0, path.end().maxAbsDifference(end), 1e-9);
    at(path, 0, sample);
    assertEquals(0, sample.positionRad().maxAbsDifference(READY), 1e-9);
  }

  @Test
  void turnsEvenlyToTheGoalInMode0() throws PlanningException {
    Pose goal = Poses.trans(shifted(0.16, 0, 0), new Pose(0, 0, 0, 0.4, 0.2, -0.3));
    MotionPath path = arc(shifted(0.08, 0.03, 0), goal, false);
    double whole = Poses.rotationAngle(home, goal);
    MotionSample sample = new MotionSample();
    for (double part = 0; part <= 1; part += 0.125) {
      Pose now = at(path, part * path.length(), sample);
      assertEquals(part * whole, Poses.rotationAngle(home, now), 1e-9);
    }
  }

  @Test
  void isALineWhereTheMiddlePointLiesOnIt() throws PlanningException {
    MotionPath path = arc(shifted(0.05, 0.05, 0), shifted(0.1, 0.1, 0), false);
    assertEquals(0.1 * Math.sqrt(2), path.length(), 1e-12);
    MotionSample sample = new MotionSample();
    Pose middle = at(path, 0.5 * path.length(), sample);
    assertEquals(0, Poses.pointDistance(shifted(0.05, 0.05, 0), middle), 1e-9);
  }

  @Test
  void refusesAMiddlePointBeyondTheGoal() {
    PlanningException error =
        assertThrows(
            PlanningException.class, () -> arc(shifted(0.2, 0.2, 0), shifted(0.1, 0.1, 0), false));
    assertEquals("no-arc", error.code());
    assertTrue(error.getMessage().contains("the points lie on a line"), error.getMessage());
  }

  @Test
  void refusesAWayThatEndsWhereItBegins() {
    assertThrows(PlanningException.class, () -> arc(shifted(0.1, 0, 0), home, false));
  }

  @Test
  void speedsAndAccelerationsAreDerivativesOfThePositions() throws PlanningException {
    MotionPath path = arc(shifted(0.08, 0.03, 0.02), shifted(0.1, 0.1, 0.05), true);
    MotionSample low = new MotionSample();
    MotionSample here = new MotionSample();
    MotionSample high = new MotionSample();
    double step = 1e-5;
    double at = 0.4 * path.length();
    at(path, at - step, low);
    at(path, at, here);
    at(path, at + step, high);
    for (int i = 0; i < Joints.COUNT; i++) {
      double rate = (high.position[i] - low.position[i]) / (2 * step);
      double bend = (high.speed[i] - low.speed[i]) / (2 * step);
      assertEquals(rate, here.speed[i], 1e-5);
      assertEquals(bend, here.acceleration[i], 1e-3);
    }
  }

  @Test
  void entersTheSphereRoundItsEndWhereTheChordIsTheRadius() throws PlanningException {
    MotionPath path = arc(shifted(0.1, 0.1, 0), shifted(0, 0.2, 0), false);
    MotionSample sample = new MotionSample();
    double within = path.lengthWithinEnd(0.05);
    Pose now = at(path, path.length() - within, sample);
    assertEquals(0.05, Poses.pointDistance(path.waypoint(), now), 1e-9);
    assertEquals(path.length(), path.lengthWithinEnd(0.5), 1e-12);
  }
}
