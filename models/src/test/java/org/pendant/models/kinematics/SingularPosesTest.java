package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/** What the inverse chooses at the singularities and at the ends of the joint ranges. */
class SingularPosesTest {
  private static final int CASES = 200;
  private static final double TURN = 2 * Math.PI;

  static List<ArmDescription> arms() {
    return Arms.ALL;
  }

  @ParameterizedTest
  @MethodSource("arms")
  void atTheWristWrist3StaysAndTheResultSaysSo(ArmDescription arm) {
    Random random = new Random(101);
    ForwardKinematics forward = new ForwardKinematics(arm);
    InverseKinematics inverse = new InverseKinematics(arm);
    for (int n = 0; n < CASES; n++) {
      double q5 = new double[] {0, Math.PI, -Math.PI}[n % 3];
      Joints q = Arms.joints(random).with(4, q5);
      InverseResult.Reached found = reached(inverse, forward.flangePose(q), q);
      assertTrue(found.wristFree(), q::toString);
      assertEquals(q.q5(), found.q().q5(), 1e-9, q::toString);
      assertEquals(0, found.q().maxAbsDifference(q), 1e-5, q::toString);
    }
  }

  @ParameterizedTest
  @MethodSource("arms")
  void atTheElbowTheTwoSolutionsMeet(ArmDescription arm) {
    Random random = new Random(102);
    ForwardKinematics forward = new ForwardKinematics(arm);
    InverseKinematics inverse = new InverseKinematics(arm);
    for (int n = 0; n < CASES; n++) {
      double q3 = new double[] {0, Math.PI, -Math.PI}[n % 3];
      Joints q = Arms.joints(random).with(2, q3);
      InverseResult.Reached found = reached(inverse, forward.flangePose(q), q);
      assertFalse(found.wristFree(), q::toString);
      // 1e-16 in the pose is worth its square root in the joints
      assertEquals(0, found.q().maxAbsDifference(q), 1e-6, q::toString);
    }
  }

  @ParameterizedTest
  @MethodSource("arms")
  void atTheShoulderTheTwoSolutionsMeet(ArmDescription arm) {
    Random random = new Random(103);
    ForwardKinematics forward = new ForwardKinematics(arm);
    InverseKinematics inverse = new InverseKinematics(arm);
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.overTheShoulder(arm.dh(), random);
      InverseResult.Reached found = reached(inverse, forward.flangePose(q), q);
      assertFalse(found.wristFree(), q::toString);
      assertEquals(0, found.q().maxAbsDifference(q), 1e-5, q::toString);
    }
  }

  @ParameterizedTest
  @MethodSource("arms")
  void besideTwoSingularitiesAtOnceThereAreSolutionsAndTheyAreExact(ArmDescription arm) {
    Random random = new Random(106);
    ForwardKinematics forward = new ForwardKinematics(arm);
    InverseKinematics inverse = new InverseKinematics(arm);
    for (int n = 0; n < 10 * CASES; n++) {
      // stretched or folded, and the axes of joints 4 and 6 parallel, nearly or as far as rounding
      double q3 = new double[] {0, Math.PI, -Math.PI}[n % 3];
      double elbow = q3 + Math.pow(10, -4 - 12 * random.nextDouble());
      double wrist = Math.pow(10, -4 - 12 * random.nextDouble());
      Joints q = Arms.joints(random).with(2, elbow).with(4, wrist);
      Pose flange = forward.flangePose(q);
      List<Joints> solutions = inverse.all(flange, Arms.joints(random));
      assertFalse(solutions.isEmpty(), q::toString);
      for (Joints solution : solutions) {
        assertTrue(inverse.poseError(solution, flange).within(1e-10, 1e-10), q::toString);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("arms")
  void trackingGoesOnAtEachSingularity(ArmDescription arm) {
    Random random = new Random(104);
    InverseKinematics inverse = new InverseKinematics(arm);
    ForwardKinematics forward = new ForwardKinematics(arm);
    double[] transform = new double[Transforms.SIZE];
    for (int n = 0; n < CASES; n++) {
      Joints q =
          switch (n % 3) {
            case 0 -> Arms.joints(random).with(2, 0);
            case 1 -> Arms.joints(random).with(4, 0);
            default -> Arms.overTheShoulder(arm.dh(), random);
          };
      double[] tracked = q.toArray();
      forward.flange(tracked, transform);
      assertTrue(inverse.track(transform, tracked), q::toString);
      assertEquals(0, Joints.of(tracked).maxAbsDifference(q), 1e-5, q::toString);
    }
  }

  @ParameterizedTest
  @MethodSource("arms")
  void aJointIsTurnedAsNearAsItsRangeLetsIt(ArmDescription arm) {
    Random random = new Random(105);
    ForwardKinematics forward = new ForwardKinematics(arm);
    InverseKinematics inverse = new InverseKinematics(arm);
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.regularJoints(arm.dh(), 0.05, random);
      int turned = n % Joints.COUNT;
      // a full turn farther than q if the range has room for it
      double aim = q.get(turned) + TURN * (n % 2 == 0 ? 1 : -1);
      Joints near = q.with(turned, aim);
      Joints expected = arm.joints().get(turned).contains(aim) ? near : q;
      List<Joints> solutions = inverse.all(forward.flangePose(q), near);
      assertTrue(
          solutions.stream().anyMatch(found -> found.maxAbsDifference(expected) < 1e-7),
          () -> q + " near " + near + " gave " + solutions);
    }
  }

  @Test
  void aWristWithoutEndFollowsAnyNumberOfTurns() {
    for (String id : List.of("ur3", "ur3e")) {
      ArmDescription arm = ArmLibrary.load(id);
      assertTrue(arm.joints().get(5).unlimited(), id);
      ForwardKinematics forward = new ForwardKinematics(arm);
      InverseKinematics inverse = new InverseKinematics(arm);
      for (double turns : new double[] {-1000, -7, 0, 3, 1000}) {
        Joints q = new Joints(0.1, -1.5, 1.2, -1, -1.4, 0.3 + turns * TURN);
        Joints found = reached(inverse, forward.flangePose(q), q).q();
        assertEquals(0, found.maxAbsDifference(q), 1e-11, id);
        double[] tracked = q.with(5, q.q5() - 0.01).toArray();
        double[] transform = new double[Transforms.SIZE];
        forward.flange(q.toArray(), transform);
        assertTrue(inverse.track(transform, tracked), id);
        assertEquals(0, Joints.of(tracked).maxAbsDifference(q), 1e-11, id);
      }
    }
  }

  @Test
  void aFreeWrist3KeepsToItsRange() {
    Joints q = new Joints(0.1, -1.5, 1.2, -1, 0, 0.3);
    Pose flange = new ForwardKinematics(Arms.UR5E).flangePose(q);
    for (double width : new double[] {0.2, 5}) {
      List<JointLimits> limits = new ArrayList<>(Arms.UR5E.joints());
      double beyond = Math.toRadians(3);
      limits.set(5, new JointLimits(0.25 + beyond, 0.25 + width - beyond, 1, 1));
      InverseKinematics inverse = new InverseKinematics(Arms.UR5E.withJoints(limits));
      double[][] nearAndChosen = {
        {0.4, 0.4}, {0.4 - TURN, 0.4}, {0.2, 0.25}, {0.2 + TURN, 0.25}, {0.3 + width, 0.25 + width}
      };
      for (double[] each : nearAndChosen) {
        List<Joints> solutions = inverse.all(flange, q.with(5, each[0]));
        assertTrue(
            solutions.stream()
                .anyMatch(
                    found ->
                        Math.abs(found.q0() - q.q0()) < 1e-9
                            && Math.abs(found.q5() - each[1]) < 1e-12),
            () -> each[0] + " gave " + solutions);
      }
    }
  }

  @Test
  void theEndsOfARangeBelongToIt() {
    Joints q = new Joints(TURN, -1.5, 1.2, -1, -1.4, -TURN);
    ForwardKinematics forward = new ForwardKinematics(Arms.UR5E);
    InverseKinematics inverse = new InverseKinematics(Arms.UR5E);
    Joints found = reached(inverse, forward.flangePose(q), q).q();
    assertEquals(0, found.maxAbsDifference(q), 1e-12);
    assertTrue(Arms.UR5E.withinLimits(found));
  }

  @Test
  void rangesOfHalfATurnAreKept() {
    JointLimits narrow = new JointLimits(-Math.PI, 0, 1, 1);
    ArmDescription arm = Arms.UR5E.withJoints(Collections.nCopies(Joints.COUNT, narrow));
    ForwardKinematics forward = new ForwardKinematics(arm);
    InverseKinematics inverse = new InverseKinematics(arm);
    Joints q = new Joints(-0.1, -1.5, -1.2, -1, -1.4, -0.3);
    for (Joints near : List.of(q, Joints.ZERO, q.with(5, 5))) {
      List<Joints> solutions = inverse.all(forward.flangePose(q), near);
      assertTrue(Arms.contain(solutions, q, 1e-9), solutions::toString);
      assertTrue(solutions.stream().allMatch(arm::withinLimits), solutions::toString);
    }
  }

  private static InverseResult.Reached reached(
      InverseKinematics inverse, Pose flange, Joints near) {
    InverseResult result = inverse.find(flange, near, 1e-10, 1e-10);
    return assertInstanceOf(InverseResult.Reached.class, result, near::toString);
  }
}
