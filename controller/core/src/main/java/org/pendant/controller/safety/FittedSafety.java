package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.text.FloatText;

/**
 * Fitted safety configuration: as one arm can have it. Configurations come from files that are made
 * for another arm, or for any: what goes beyond the arm is taken back to what the arm can do, and
 * infinity stands for the limit that is standard for the arm.
 *
 * @param configuration what holds
 * @param changes what of the file does not hold because the arm cannot do it
 */
public record FittedSafety(SafetyConfiguration configuration, List<Change> changes) {
  /** What rounding to degrees may do, rad and rad/s. */
  private static final double ROUNDING = 1e-6;

  /**
   * A limit that does not hold as it was wanted.
   *
   * @param field which, such as {@code normal.jointMinRad}
   * @param message what was wanted, and what the arm can do
   */
  public record Change(String field, String message) {}

  public FittedSafety {
    changes = List.copyOf(changes);
  }

  /** {@code wanted} as {@code arm} can have it. */
  public static FittedSafety of(SafetyConfiguration wanted, ArmDescription arm) {
    List<Change> changes = new ArrayList<>();
    SafetyConfiguration standard = SafetyConfiguration.standard(arm);
    SafetyLimits normal =
        withJoints(finite(wanted.normal(), standard.normal()), wanted.normal(), arm, changes);
    // what is reduced is within what is normal: a change there has been told
    SafetyLimits reduced =
        withJoints(
            finite(wanted.reduced(), standard.reduced()), wanted.reduced(), arm, new ArrayList<>());
    return new FittedSafety(wanted.withLimits(normal, within(reduced, normal)), changes);
  }

  /** The limits with those of {@code standard} where there is none. */
  private static SafetyLimits finite(SafetyLimits limits, SafetyLimits standard) {
    double[] speed = limits.jointSpeedRadPerS().toArray();
    for (int i = 0; i < speed.length; i++) {
      speed[i] = finite(speed[i], standard.jointSpeedRadPerS().get(i));
    }
    return new SafetyLimits(
        finite(limits.powerW(), standard.powerW()),
        finite(limits.momentumKgMPerS(), standard.momentumKgMPerS()),
        finite(limits.stoppingTimeS(), standard.stoppingTimeS()),
        finite(limits.stoppingDistanceM(), standard.stoppingDistanceM()),
        finite(limits.toolSpeedMPerS(), standard.toolSpeedMPerS()),
        finite(limits.toolForceN(), standard.toolForceN()),
        finite(limits.elbowSpeedMPerS(), standard.elbowSpeedMPerS()),
        finite(limits.elbowForceN(), standard.elbowForceN()),
        Joints.of(speed),
        limits.jointMinRad(),
        limits.jointMaxRad());
  }

  private static double finite(double limit, double standard) {
    return Double.isInfinite(limit) ? standard : limit;
  }

  private static SafetyLimits withJoints(
      SafetyLimits limits, SafetyLimits wanted, ArmDescription arm, List<Change> changes) {
    double[] speed = limits.jointSpeedRadPerS().toArray();
    double[] min = limits.jointMinRad().toArray();
    double[] max = limits.jointMaxRad().toArray();
    for (int i = 0; i < Joints.COUNT; i++) {
      double most = StandardLimits.mostJointSpeedRadPerS(arm, i);
      if (speed[i] > most + ROUNDING) {
        speed[i] = most;
        changes.add(
            new Change(
                "normal.jointSpeedRadPerS",
                text(
                    "jointTooFastForArm",
                    i,
                    wanted.jointSpeedRadPerS().get(i),
                    FloatText.of(most),
                    arm.id())));
      }
      fitRange(i, min, max, arm, changes);
    }
    return new SafetyLimits(
        limits.powerW(),
        limits.momentumKgMPerS(),
        limits.stoppingTimeS(),
        limits.stoppingDistanceM(),
        limits.toolSpeedMPerS(),
        limits.toolForceN(),
        limits.elbowSpeedMPerS(),
        limits.elbowForceN(),
        Joints.of(speed),
        Joints.of(min),
        Joints.of(max));
  }

  /** No limit at all stands for that of the arm. */
  private static void fitRange(
      int i, double[] min, double[] max, ArmDescription arm, List<Change> changes) {
    JointLimits joint = arm.joints().get(i);
    double least = joint.lowestRad();
    double most = joint.highestRad();
    boolean below = Double.isFinite(min[i]) && min[i] < least - ROUNDING;
    boolean above = Double.isFinite(max[i]) && max[i] > most + ROUNDING;
    boolean apart = min[i] >= most || max[i] <= least;
    if (!below && !above && !apart) {
      return;
    }
    double wantedMin = min[i];
    double wantedMax = max[i];
    min[i] = below || apart ? least : min[i];
    max[i] = above || apart ? most : max[i];
    changes.add(
        new Change(
            "normal.jointMinRad",
            text(
                "jointRangeBeyondArm",
                i,
                FloatText.of(wantedMin),
                FloatText.of(wantedMax),
                FloatText.of(least),
                FloatText.of(most),
                arm.id())));
  }

  /** The tighter one of each limit; a range that would be empty is the normal one. */
  private static SafetyLimits within(SafetyLimits reduced, SafetyLimits normal) {
    double[] min = reduced.jointMinRad().toArray();
    double[] max = reduced.jointMaxRad().toArray();
    for (int i = 0; i < Joints.COUNT; i++) {
      boolean empty =
          Math.max(min[i], normal.jointMinRad().get(i))
              >= Math.min(max[i], normal.jointMaxRad().get(i));
      if (empty) {
        min[i] = Double.NEGATIVE_INFINITY;
        max[i] = Double.POSITIVE_INFINITY;
      }
    }
    return new SafetyLimits(
            reduced.powerW(),
            reduced.momentumKgMPerS(),
            reduced.stoppingTimeS(),
            reduced.stoppingDistanceM(),
            reduced.toolSpeedMPerS(),
            reduced.toolForceN(),
            reduced.elbowSpeedMPerS(),
            reduced.elbowForceN(),
            reduced.jointSpeedRadPerS(),
            Joints.of(min),
            Joints.of(max))
        .tighterOf(normal);
  }
}
