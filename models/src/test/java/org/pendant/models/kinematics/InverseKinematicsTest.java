package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.StraightLine;
import org.pendant.models.pose.Transforms;

class InverseKinematicsTest {
  private static final int CASES = 1000;

  private final ForwardKinematics forward = new ForwardKinematics(Arms.UR5E);
  private final InverseKinematics inverse = new InverseKinematics(Arms.UR5E);

  @Test
  void everySolutionReachesThePoseAndLiesWithinTheLimits() {
    Random random = new Random(51);
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      Joints near = Arms.joints(random);
      Pose flange = forward.flangePose(q);
      List<Joints> solutions = inverse.all(flange, near);
      assertTrue(solutions.size() >= 2, q::toString);
      for (Joints solution : solutions) {
        assertTrue(inverse.poseError(solution, flange).within(1e-10, 1e-10), q::toString);
        assertTrue(Arms.UR5E.withinLimits(solution), q::toString);
      }
    }
  }

  @Test
  void theSolutionNearTheJointsThatMadeThePoseIsThoseJoints() {
    Random random = new Random(52);
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      Joints found = inverse.closest(forward.flangePose(q), q).orElseThrow();
      // near a singularity 1e-16 in the pose is worth up to its square root in the joints
      assertEquals(0, found.maxAbsDifference(q), 1e-7, q::toString);
    }
  }

  @Test
  void solutionsComeInTheOrderOfTheirDistance() {
    Random random = new Random(53);
    for (int n = 0; n < CASES; n++) {
      Pose flange = forward.flangePose(Arms.joints(random));
      Joints near = Arms.joints(random);
      List<Joints> solutions = inverse.all(flange, near);
      for (int i = 1; i < solutions.size(); i++) {
        assertTrue(
            solutions.get(i - 1).squaredDistance(near) <= solutions.get(i).squaredDistance(near),
            () -> flange + " near " + near);
      }
      assertEquals(Optional.of(solutions.getFirst()), inverse.closest(flange, near));
    }
  }

  @Test
  void noFullTurnWouldBringASolutionNearer() {
    Random random = new Random(54);
    for (int n = 0; n < CASES; n++) {
      Pose flange = forward.flangePose(Arms.joints(random));
      Joints near = Arms.joints(random);
      for (Joints solution : inverse.all(flange, near)) {
        for (int i = 0; i < Joints.COUNT; i++) {
          for (double turn : new double[] {-2 * Math.PI, 2 * Math.PI}) {
            Joints turned = solution.with(i, solution.get(i) + turn);
            assertTrue(
                !Arms.UR5E.withinLimits(turned)
                    || turned.squaredDistance(near) >= solution.squaredDistance(near) - 1e-9,
                () -> flange + " near " + near + " gave " + solution);
          }
        }
      }
    }
  }

  @Test
  void eightSolutionsAreFoundWhereTheArmHasThem() {
    Pose flange = forward.flangePose(new Joints(0.1, -1.5, 1.2, -1, -1.4, 0.3));
    List<Joints> solutions = inverse.all(flange, Joints.ZERO);
    assertEquals(8, solutions.size());
    for (int i = 0; i < 8; i++) {
      for (int j = 0; j < i; j++) {
        assertTrue(solutions.get(i).maxAbsDifference(solutions.get(j)) > 0.1);
      }
    }
  }

  @Test
  void atTheWristSingularityWrist3StaysWhereItIsAsked() {
    Random random = new Random(55);
    for (int n = 0; n < CASES; n++) {
      // a bent elbow, and wrist 1 away from its ends, leave the arm room to let wrist 3 be
      Joints q =
          withParallelWrist(random).with(2, 0.8 + random.nextDouble()).with(3, random.nextDouble());
      Joints near = q.with(5, q.q5() + (q.q5() > 0 ? -0.1 : 0.1));
      List<Joints> solutions = inverse.all(forward.flangePose(q), near);
      assertTrue(
          solutions.stream()
              .anyMatch(
                  found ->
                      Math.abs(found.q0() - q.q0()) < 1e-7
                          && Math.abs(found.q5() - near.q5()) < 1e-12),
          () -> q + " near " + near + " gave " + solutions);
    }
  }

  @Test
  void theResultTellsThatWrist3WasFree() {
    Joints q = new Joints(0.1, -1.5, 1.2, -1, 0, 0.3);
    InverseResult result = inverse.find(forward.flangePose(q), q, 1e-10, 1e-10);
    assertTrue(assertInstanceOf(InverseResult.Reached.class, result).wristFree());
    result = inverse.find(forward.flangePose(q.with(4, 0.1)), q, 1e-10, 1e-10);
    assertFalse(assertInstanceOf(InverseResult.Reached.class, result).wristFree());
  }

  @Test
  void atTheWristSingularityAnArmWithoutRoomTurnsWrist3JustEnough() {
    // nearly stretched: wrist 3 where it is asked would need a longer arm
    Joints q = new Joints(-0.244, -1.019, 0.257, -0.888, -Math.PI, 5.367);
    Joints near = q.with(5, 5.467);
    List<Joints> solutions = inverse.all(forward.flangePose(q), near);
    assertTrue(
        solutions.stream()
            .anyMatch(
                found ->
                    Math.abs(found.q0() - q.q0()) < 1e-9
                        && found.q5() > q.q5()
                        && found.q5() < near.q5()
                        && Singularity.ELBOW.measure(Arms.UR5E.dh(), found) < 1e-6),
        solutions::toString);
  }

  @Test
  void atTheWristSingularityThereIsAlwaysASolution() {
    Random random = new Random(61);
    for (int n = 0; n < CASES; n++) {
      Joints q = withParallelWrist(random);
      Joints near = q.with(5, Arms.joints(random).q5());
      List<Joints> solutions = inverse.all(forward.flangePose(q), near);
      // with the shoulder as it was; the other side may have one as well
      assertTrue(
          solutions.stream()
              .anyMatch(found -> Math.abs(Math.sin(0.5 * (found.q0() - q.q0()))) < 1e-7),
          () -> q + " near " + near + " gave " + solutions);
    }
  }

  @Test
  void aStretchedArmHasASolution() {
    Random random = new Random(56);
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random).with(2, 0);
      assertTrue(inverse.closest(forward.flangePose(q), q).isPresent(), q::toString);
    }
  }

  @Test
  void theShoulderSingularityHasASolution() {
    Random random = new Random(57);
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.overTheShoulder(Arms.UR5E.dh(), random);
      assertEquals(0, Singularity.SHOULDER.measure(Arms.UR5E.dh(), q), 1e-12);
      assertTrue(inverse.closest(forward.flangePose(q), q).isPresent(), q::toString);
    }
  }

  @Test
  void aTcpOffsetIsTakenBack() {
    Random random = new Random(58);
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      Pose offset = Arms.tcp(random);
      Pose tcp = forward.tcpPose(q, offset);
      Joints found = inverse.solve(tcp, offset, q).orElseThrow();
      Pose again = forward.tcpPose(found, offset);
      assertEquals(0, Poses.pointDistance(tcp, again), 1e-10, q::toString);
      assertEquals(0, Poses.rotationAngle(tcp, again), 1e-10, q::toString);
    }
  }

  @Test
  void aPoseTooFarAwayIsUnreachableAndSaysSo() {
    InverseResult result = inverse.find(Pose.of(2, 0, 0.3, 0, 3.14, 0), Joints.ZERO, 1e-10, 1e-10);
    InverseResult.Unreachable none = assertInstanceOf(InverseResult.Unreachable.class, result);
    assertEquals(InverseResult.Cause.TOO_FAR, none.cause());
    assertTrue(none.leastError().positionM() > 1 && none.leastError().positionM() < 1.3);
  }

  @Test
  void aPoseOnTheBaseAxisIsUnreachableAndSaysSo() {
    for (Pose pose : List.of(Pose.of(0, 0, 0.8, 0, 3.14, 0), Pose.of(0, 0, 0.8, 0, 0, 0))) {
      InverseResult result = inverse.find(pose, Joints.ZERO, 1e-10, 1e-10);
      InverseResult.Unreachable none = assertInstanceOf(InverseResult.Unreachable.class, result);
      assertEquals(InverseResult.Cause.TOO_CLOSE_TO_BASE_AXIS, none.cause());
    }
  }

  @Test
  void aPoseJustOutOfReachCountsIfTheErrorIsAllowed() {
    Joints stretched = new Joints(0.3, -0.8, 0, -0.5, 1.2, 0.4);
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    forward.frames(stretched.toArray(), frames);
    Pose at = forward.flangePose(stretched);
    // along the stretched arm, 1 mm farther
    double dx = frames[2][9] - frames[0][9];
    double dy = frames[2][10] - frames[0][10];
    double dz = frames[2][11] - frames[0][11];
    double scale = 0.001 / Math.sqrt(dx * dx + dy * dy + dz * dz);
    Pose beyond =
        at.with(0, at.x() + scale * dx).with(1, at.y() + scale * dy).with(2, at.z() + scale * dz);
    assertEquals(Optional.empty(), inverse.closest(beyond, stretched));
    InverseResult.Reached reached =
        assertInstanceOf(
            InverseResult.Reached.class, inverse.find(beyond, stretched, 0.002, 1e-10));
    assertEquals(0.001, reached.error().positionM(), 1e-9);
    assertEquals(0, reached.q().maxAbsDifference(stretched), 1e-6);
  }

  @Test
  void solutionsOutsideTheRangeOfAJointAreNotGiven() {
    JointLimits narrow = new JointLimits(0.5, 0.6, 1, 1);
    ArmDescription arm = Arms.UR5E.withJoints(Collections.nCopies(Joints.COUNT, narrow));
    InverseKinematics ofNarrow = new InverseKinematics(arm);
    Joints inside = Joints.of(0.55, 0.55, 0.55, 0.55, 0.55, 0.55);
    assertEquals(1, ofNarrow.all(forward.flangePose(inside), Joints.ZERO).size());
    InverseResult result =
        ofNarrow.find(forward.flangePose(inside.with(0, 0.7)), inside, 1e-10, 1e-10);
    InverseResult.Unreachable none = assertInstanceOf(InverseResult.Unreachable.class, result);
    assertEquals(InverseResult.Cause.JOINT_LIMITS, none.cause());
  }

  @Test
  void trackingALineStaysOnItWithoutAJump() {
    Random random = new Random(59);
    double[] transform = new double[Transforms.SIZE];
    for (int n = 0; n < 100; n++) {
      Joints start = new Joints(0.1, -1.5, 1.2, -1, -1.4, 0.3);
      Pose from = forward.flangePose(start);
      Pose to = Poses.trans(from, Arms.tcp(random));
      StraightLine line = new StraightLine(from, shortened(from, to));
      double[] q = start.toArray();
      double[] before = new double[Joints.COUNT];
      for (int step = 0; step <= 500; step++) {
        System.arraycopy(q, 0, before, 0, Joints.COUNT);
        line.at(step / 500.0, transform);
        assertTrue(inverse.track(transform, q), to::toString);
        assertTrue(
            Joints.of(q).maxAbsDifference(Joints.of(before)) < 0.1, () -> "jump towards " + to);
        assertTrue(
            inverse.poseError(Joints.of(q), line.at(step / 500.0)).within(1e-10, 1e-10),
            to::toString);
      }
    }
  }

  @Test
  void trackingFindsTheSameAsTheFullSearchForASmallStep() {
    Random random = new Random(60);
    double[] transform = new double[Transforms.SIZE];
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      double[] nearby = q.toArray();
      for (int i = 0; i < nearby.length; i++) {
        nearby[i] += 1e-3 * (random.nextDouble() - 0.5);
      }
      Joints near = Joints.of(nearby);
      forward.flange(q.toArray(), transform);
      assertTrue(inverse.track(transform, nearby), q::toString);
      Joints full = inverse.closest(forward.flangePose(q), near).orElseThrow();
      assertEquals(0, full.maxAbsDifference(Joints.of(nearby)), 1e-6, q::toString);
    }
  }

  @Test
  void framesThatTrackingKnowsAreThoseOfTheJointsItFound() {
    Random random = new Random(61);
    double[] transform = new double[Transforms.SIZE];
    double[][] known = new double[Joints.COUNT][Transforms.SIZE];
    double[][] expected = new double[Joints.COUNT][Transforms.SIZE];
    for (int n = 0; n < CASES; n++) {
      Joints goal = Arms.joints(random);
      // every fourth one is far away, where the path cannot simply be continued
      double step = n % 4 == 0 ? 4 : 1e-2;
      double[] q = goal.toArray();
      for (int i = 0; i < q.length; i++) {
        q[i] += step * (random.nextDouble() - 0.5);
      }
      forward.flange(goal.toArray(), transform);
      assertTrue(inverse.track(transform, q), goal::toString);
      inverse.trackedFrames(q, known);
      forward.frames(q, expected);
      for (int i = 0; i < Joints.COUNT; i++) {
        assertArrayEquals(expected[i], known[i], 1e-9, goal.toString());
      }
    }
  }

  @Test
  void trackingBeyondTheReachLeavesTheJointsAlone() {
    double[] q = {0.1, -1.5, 1.2, -1, -1.4, 0.3};
    double[] before = q.clone();
    double[] transform = new double[Transforms.SIZE];
    Transforms.of(Pose.of(3, 0, 0, 0, 0, 0), transform);
    assertFalse(inverse.track(transform, q));
    assertArrayEquals(before, q);
  }

  @Test
  void solutionsInPlaceAreThoseOfTheList() {
    Random random = new Random(62);
    double[] transform = new double[Transforms.SIZE];
    double[][] solutions = new double[InverseKinematics.MAX_SOLUTIONS][Joints.COUNT];
    for (int n = 0; n < CASES; n++) {
      Pose flange = forward.flangePose(Arms.joints(random));
      Joints near = Arms.joints(random);
      Transforms.of(flange, transform);
      int count = inverse.allInto(transform, near.toArray(), solutions);
      List<Joints> listed = inverse.all(flange, near);
      assertEquals(listed.size(), count);
      for (int i = 0; i < count; i++) {
        assertEquals(listed.get(i), Joints.of(solutions[i]));
      }
    }
  }

  @Test
  void aMatrixThatIsNoRotationHasNoSolution() {
    double[] transform = new double[Transforms.SIZE];
    double[][] solutions = new double[InverseKinematics.MAX_SOLUTIONS][Joints.COUNT];
    double[] q = {0.1, -1.5, 1.2, -1, -1.4, 0.3};
    forward.flange(q, transform);
    assertEquals(8, inverse.allInto(transform, q, solutions));
    for (int i = 0; i < 9; i++) {
      double[] wrong = transform.clone();
      wrong[i] += 1e-9;
      assertEquals(0, inverse.allInto(wrong, q, solutions), "entry " + i);
    }
    transform[9] = Double.NaN;
    assertEquals(0, inverse.allInto(transform, q, solutions));
  }

  @Test
  void inputsThatAreNotFiniteAreRefused() {
    assertThrows(
        IllegalArgumentException.class,
        () -> inverse.closest(Pose.ZERO.with(4, Double.NaN), Joints.ZERO));
    assertThrows(
        IllegalArgumentException.class,
        () -> inverse.closest(Pose.ZERO, Joints.ZERO.with(2, Double.POSITIVE_INFINITY)));
    assertThrows(
        IllegalArgumentException.class, () -> inverse.find(Pose.ZERO, Joints.ZERO, -1, Double.NaN));
  }

  /** At most 0.2 of the way, so that the arm stays away from its singularities. */
  private static Pose shortened(Pose from, Pose to) {
    return Poses.interpolate(from, to, 0.2);
  }

  /** Joints with the axes of joints 4 and 6 parallel. */
  private static Joints withParallelWrist(Random random) {
    double q4 = new double[] {0, Math.PI, -Math.PI}[random.nextInt(3)];
    return Arms.joints(random).with(4, q4);
  }
}
