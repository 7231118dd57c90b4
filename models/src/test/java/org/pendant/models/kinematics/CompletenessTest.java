package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/** The solutions of a pose are all there are, for every arm. */
@Tag("slow")
class CompletenessTest {
  private static final int POSES = 1000;
  private static final int SEARCHED_POSES = 20;
  private static final int STARTS = 60;

  static List<ArmDescription> arms() {
    return Arms.ALL;
  }

  @ParameterizedTest
  @MethodSource("arms")
  void solutionsAreExactAndAmongThemIsWhatMadeThePose(ArmDescription arm) {
    Random random = new Random(91);
    ForwardKinematics forward = new ForwardKinematics(arm);
    InverseKinematics inverse = new InverseKinematics(arm);
    for (int n = 0; n < POSES; n++) {
      Joints q = Arms.joints(random);
      Pose flange = forward.flangePose(q);
      List<Joints> solutions = inverse.all(flange, Arms.joints(random));
      for (Joints solution : solutions) {
        assertTrue(inverse.poseError(solution, flange).within(1e-10, 1e-10), q::toString);
        assertTrue(arm.withinLimits(solution), q::toString);
      }
      // near a singularity 1e-16 in the pose is worth up to its square root in the joints
      assertTrue(Arms.contain(solutions, q, 1e-6), () -> q + " gave " + solutions);
    }
  }

  @ParameterizedTest
  @MethodSource("arms")
  void aNumericalSearchFindsNoOther(ArmDescription arm) {
    Random random = new Random(92);
    ForwardKinematics forward = new ForwardKinematics(arm);
    InverseKinematics inverse = new InverseKinematics(arm);
    Refinement newton = new Refinement(arm);
    double[] target = new double[Transforms.SIZE];
    int found = 0;
    for (int n = 0; n < SEARCHED_POSES; n++) {
      Joints made = Arms.regularJoints(arm.dh(), 0.05, random);
      Pose flange = forward.flangePose(made);
      Transforms.of(flange, target);
      List<Joints> solutions = inverse.all(flange, Joints.ZERO);
      for (int start = 0; start < STARTS; start++) {
        double[] q = Arms.joints(random).toArray();
        if (newton.refine(target, q, 1e-10)) {
          found++;
          Joints other = Joints.of(q);
          assertTrue(
              Arms.contain(solutions, other, 1e-5),
              () -> other + " is missing in " + solutions + " for " + made);
        }
      }
    }
    assertTrue(
        found > SEARCHED_POSES * STARTS / 4, "the search came to an end " + found + " times");
  }
}
