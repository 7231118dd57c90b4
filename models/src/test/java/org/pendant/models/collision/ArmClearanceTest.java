package org.pendant.models.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;

class ArmClearanceTest {
  private static final ArmDescription UR5E = ArmLibrary.load("ur5e");

  /** Upright, forearm level, tool down. */
  private static final double[] START = {
    0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0
  };

  /** So little may shapes overlap that real links do not have: wrist 2 of a UR5 by 2 mm. */
  private static final double ROUNDED_OFF_M = -0.004;

  private final List<Capsule> links = LinkCapsules.of(UR5E);

  @Test
  void everyArmIsClearOfItselfWhereProgramsBegin() {
    for (String id : ArmLibrary.ids()) {
      ArmDescription arm = ArmLibrary.load(id);
      ArmClearance clearance = new ArmClearance(arm, LinkCapsules.of(arm), List.of());
      clearance.at(START);
      double least = least(clearance);
      assertTrue(least > 0.01, () -> id + ": " + least + " m");
    }
  }

  @Test
  void everyArmIsClearOfItselfStretchedOutAndUpright() {
    for (String id : ArmLibrary.ids()) {
      ArmDescription arm = ArmLibrary.load(id);
      ArmClearance clearance = new ArmClearance(arm, LinkCapsules.of(arm), List.of());
      for (double[] q : List.of(new double[6], new double[] {0, -Math.PI / 2, 0, -1.57, 0, 0})) {
        clearance.at(q);
        double least = least(clearance);
        assertTrue(least > 0.005, () -> id + ": " + least + " m");
      }
    }
  }

  @Test
  void bodiesThatAreNoPairNeverTouchUnlessTheyAreNeighbours() {
    Random random = new Random(8);
    for (String id : ArmLibrary.ids()) {
      ArmDescription arm = ArmLibrary.load(id);
      ArmClearance clearance = new ArmClearance(arm, LinkCapsules.of(arm), List.of());
      for (int n = 0; n < 100; n++) {
        clearance.at(joints(random));
        for (int one = 0; one < LinkCapsules.WRIST_3; one++) {
          for (int other = one + 2; other <= LinkCapsules.WRIST_3; other++) {
            double apart = clearance.ofBodies(one, other, Double.POSITIVE_INFINITY);
            String what = id + ": " + one + " and " + other + ": " + apart;
            assertTrue(ArmClearance.canTouch(one, other) || apart > ROUNDED_OFF_M, what);
          }
        }
      }
    }
  }

  @Test
  void aForearmFoldedBackHitsTheShoulder() {
    ArmClearance clearance = new ArmClearance(UR5E, links, List.of());
    clearance.at(new double[] {0, -Math.PI / 2, Math.PI - 0.05, 0, 0, 0});
    assertTrue(distance(clearance, "shoulder", "wrist 1") < 0 || least(clearance) < 0);
    assertTrue(distance(clearance, "shoulder", "forearm") < 0);
  }

  /**
   * The pairs that are as far apart as they can be, by the names of the body and of the number of
   * the obstacle.
   */
  private List<String> farthest(double[] q, SolidShape... obstacles) {
    ArmClearance clearance = new ArmClearance(UR5E, links, List.of(obstacles));
    clearance.at(q);
    List<String> found = new ArrayList<>();
    for (int pair = 0; pair < clearance.pairs(); pair++) {
      if (clearance.farthest(pair, clearance.distanceM(pair, Double.POSITIVE_INFINITY))) {
        String other =
            clearance.obstacle(pair) >= 0
                ? String.valueOf(clearance.obstacle(pair))
                : LinkCapsules.name(clearance.otherBody(pair));
        found.add(LinkCapsules.name(clearance.body(pair)) + ", " + other);
      }
    }
    return found;
  }

  @Test
  void noJointChangesHowFarTheShoulderIsFromWhatIsAlikeAllAroundItsAxis() {
    for (SolidShape each :
        List.of(
            new SolidShape.HalfSpace(0, 0, -0.1, 0, 0, 1),
            new SolidShape.Block(new Pose(0, 0, -0.1, 0, 0, 0), 1, 1, 0.1),
            new SolidShape.Ball(0, 0, 0.9, 0.1))) {
      List<String> found = farthest(new double[] {1, 0.4, 0.6, 0, 0, 0}, each);
      assertTrue(found.contains("shoulder, 0"), () -> each + ": " + found);
    }
  }

  @Test
  void anUpperArmThatPointsUpFromAFloorCannotBeFartherFromIt() {
    SolidShape floor = new SolidShape.HalfSpace(0, 0, 0, 0, 0, 1);
    assertEquals(List.of("shoulder, 0", "upper arm, 0"), farthest(START, floor));
    assertEquals(List.of("shoulder, 0"), farthest(new double[] {0, 0.2, -1, 0, 0, 0}, floor));
  }

  @Test
  void jointsCanMakeAllOtherDistancesLarger() {
    double slope = Math.sqrt(0.5);
    SolidShape wall = new SolidShape.HalfSpace(0, 0, -0.2, slope, 0, slope);
    double[] towards = START.clone();
    double[] away = START.clone();
    towards[0] = -Math.PI / 2;
    away[0] = Math.PI / 2;
    assertEquals(List.of(), farthest(START));
    assertEquals(List.of(), farthest(towards, wall));
    assertEquals(List.of("shoulder, 0"), farthest(away, wall));
  }

  @Test
  void whatIsInAnObstacleWhereverTheJointsAreIsNoneOfThese() {
    SolidShape floor = new SolidShape.HalfSpace(0, 0, 0.16, 0, 0, 1);
    assertEquals(List.of(), farthest(new double[] {0, 0.2, -1, 0, 0, 0}, floor));
  }

  @Test
  void theFlangeIsWhereTheKinematicsSay() {
    Random random = new Random(3);
    ForwardKinematics forward = new ForwardKinematics(UR5E);
    for (int n = 0; n < 50; n++) {
      double[] q = joints(random);
      Pose flange = forward.flangePose(Joints.of(q));
      // a ball at the flange is as far from the face of wrist 3 as its radius says
      ArmClearance clearance =
          new ArmClearance(
              UR5E, links, List.of(new SolidShape.Ball(flange.x(), flange.y(), flange.z(), 0.01)));
      clearance.at(q);
      double[] least = {1};
      for (int pair = 0; pair < clearance.pairs(); pair++) {
        if (clearance.obstacle(pair) == 0 && clearance.body(pair) == LinkCapsules.WRIST_3) {
          least[0] = clearance.distanceM(pair, 1);
        }
      }
      assertEquals(-0.01, least[0], 2e-4);
    }
  }

  @Test
  void capsulesOfALimbLieBetweenItsJoints() {
    Random random = new Random(4);
    DhLengths dh = UR5E.dh();
    double[][] frames = new double[6][12];
    ForwardKinematics forward = new ForwardKinematics(UR5E);
    for (int n = 0; n < 20; n++) {
      double[] q = joints(random);
      forward.frames(q, frames);
      // the middle of the tube of the upper arm: half way, and to the side along the axis
      double[] at = new double[3];
      for (int i = 0; i < 3; i++) {
        at[i] = (frames[0][9 + i] + frames[1][9 + i]) / 2 + 0.1378 * frames[0][3 * i + 2];
      }
      ArmClearance clearance =
          new ArmClearance(
              UR5E, links, List.of(new SolidShape.Ball(at[0], at[1], at[2], -dh.a2() / 100)));
      clearance.at(q);
      double deep = distance(clearance, "upper arm", 0);
      assertEquals(-0.0428 - 0.00425, deep, 1e-9);
    }
  }

  @Test
  void distancesChangeNoFasterThanTheArmTravels() {
    Random random = new Random(5);
    List<SolidShape> obstacles =
        List.of(
            new SolidShape.HalfSpace(0, 0, 0, 0, 0, 1),
            new SolidShape.Ball(0.4, 0.2, 0.3, 0.1),
            new SolidShape.Block(new Pose(-0.5, 0.1, 0.4, 0.3, 0.2, 0.1), 0.2, 0.3, 0.4));
    List<Capsule> all = new ArrayList<>(links);
    all.add(new Capsule(LinkCapsules.TOOL, 0, 0, 0.1, 0, 0, 0.1, 0.05));
    ArmClearance clearance = new ArmClearance(UR5E, all, obstacles);
    for (int n = 0; n < 300; n++) {
      double[] from = joints(random);
      double[] to = from.clone();
      for (int i = 0; i < 6; i++) {
        to[i] += 0.2 * random.nextDouble() - 0.1;
      }
      clearance.at(from);
      double[] before = all(clearance);
      double travel = clearance.travelM(to);
      clearance.at(to);
      double[] after = all(clearance);
      for (int pair = 0; pair < before.length; pair++) {
        double change = Math.abs(after[pair] - before[pair]);
        String what = n + ": pair " + pair + " " + change + " m of " + travel;
        assertTrue(change <= travel + 1e-6, what);
      }
    }
  }

  @Test
  void aDistanceThatNeedNotBeExactIsABoundBelowIt() {
    Random random = new Random(6);
    ArmClearance clearance =
        new ArmClearance(
            UR5E,
            links,
            List.of(new SolidShape.Block(new Pose(0.5, 0, 0.2, 0, 0, 0), 0.2, 0.3, 0.4)));
    for (int n = 0; n < 100; n++) {
      clearance.at(joints(random));
      for (int pair = 0; pair < clearance.pairs(); pair++) {
        double exact = clearance.distanceM(pair, Double.POSITIVE_INFINITY);
        double bound = clearance.distanceM(pair, 0.05);
        assertTrue(bound <= exact + 1e-9 && (bound == exact || bound >= 0.05), bound + " " + exact);
      }
    }
  }

  @Test
  void whatIsBeyondTheReachOfTheArmIsNotLookedAt() {
    int alone = new ArmClearance(UR5E, links, List.of()).pairs();
    assertEquals(
        alone, new ArmClearance(UR5E, links, List.of(new SolidShape.Ball(3, 0, 0, 0.5))).pairs());
    assertEquals(
        alone + 6,
        new ArmClearance(UR5E, links, List.of(new SolidShape.Ball(3, 0, 0, 2.5))).pairs());
  }

  private static double[] joints(Random random) {
    double[] q = new double[6];
    for (int i = 0; i < 6; i++) {
      q[i] = 2 * Math.PI * (random.nextDouble() - 0.5);
    }
    return q;
  }

  private static double[] all(ArmClearance clearance) {
    double[] all = new double[clearance.pairs()];
    for (int pair = 0; pair < all.length; pair++) {
      all[pair] = clearance.distanceM(pair, Double.POSITIVE_INFINITY);
    }
    return all;
  }

  private static double least(ArmClearance clearance) {
    double least = Double.POSITIVE_INFINITY;
    for (double each : all(clearance)) {
      least = Math.min(least, each);
    }
    return least;
  }

  private static double distance(ArmClearance clearance, String body, String other) {
    return distanceOf(clearance, number(body), number(other), -1);
  }

  private static double distance(ArmClearance clearance, String body, int obstacle) {
    return distanceOf(clearance, number(body), -1, obstacle);
  }

  private static int number(String body) {
    return IntStream.range(0, LinkCapsules.BODIES)
        .filter(each -> LinkCapsules.name(each).equals(body))
        .findFirst()
        .orElseThrow();
  }

  private static double distanceOf(ArmClearance clearance, int body, int other, int obstacle) {
    for (int pair = 0; pair < clearance.pairs(); pair++) {
      if (clearance.body(pair) == body
          && clearance.otherBody(pair) == other
          && clearance.obstacle(pair) == obstacle) {
        return clearance.distanceM(pair, Double.POSITIVE_INFINITY);
      }
    }
    throw new IllegalArgumentException("no such pair");
  }
}
