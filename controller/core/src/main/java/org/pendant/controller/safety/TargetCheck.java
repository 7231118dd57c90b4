package org.pendant.controller.safety;

import java.util.Arrays;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/** Target check: whether the target continues from where it was (C204). */
final class TargetCheck {
  /** Over the largest speed of a joint: what rounding and returning to a path may add. */
  private static final double MARGIN = 1.1;

  /** Change of a joint's speed in one frame that no motion needs, rad/s: 500 rad/s². */
  static final double SPEED_JUMP_RAD_PER_S = 1;

  private final double[] largestStepRad = new double[Joints.COUNT];
  private final double[] lastQ = new double[Joints.COUNT];
  private final double[] lastQd = new double[Joints.COUNT];
  private boolean hasLast;

  TargetCheck(ArmDescription arm) {
    for (int i = 0; i < Joints.COUNT; i++) {
      largestStepRad[i] = MARGIN * arm.joints().get(i).maxSpeedRadPerS() * FrameTime.FRAME_S;
    }
  }

  /** The next target may be anywhere. */
  void forget() {
    hasLast = false;
  }

  /** Compares a target with the one before. */
  Optional<SafetyStop> check(double timeS, Observation seen) {
    Optional<SafetyStop> stop = hasLast ? jump(timeS, seen) : Optional.empty();
    remember(seen);
    return stop;
  }

  /** Takes a target as it is. */
  void remember(Observation seen) {
    System.arraycopy(seen.targetQ, 0, lastQ, 0, Joints.COUNT);
    System.arraycopy(seen.targetQd, 0, lastQd, 0, Joints.COUNT);
    hasLast = true;
  }

  private Optional<SafetyStop> jump(double timeS, Observation seen) {
    if (Arrays.equals(seen.targetQ, lastQ) && Arrays.equals(seen.targetQd, lastQd)) {
      return Optional.empty();
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      double step = Math.abs(seen.targetQ[i] - lastQ[i]);
      if (step > largestStepRad[i]) {
        return Optional.of(
            StopReason.TARGET_POSITION_JUMP.ofJoint(i, timeS, step, largestStepRad[i]));
      }
      double change = Math.abs(seen.targetQd[i] - lastQd[i]);
      if (change > SPEED_JUMP_RAD_PER_S) {
        return Optional.of(
            StopReason.TARGET_SPEED_JUMP.ofJoint(i, timeS, change, SPEED_JUMP_RAD_PER_S));
      }
    }
    return Optional.empty();
  }
}
