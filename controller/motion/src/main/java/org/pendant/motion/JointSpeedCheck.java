package org.pendant.motion;

import static org.pendant.motion.MotionTexts.text;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.text.FloatText;
import org.pendant.models.time.FrameTime;

/**
 * Joint speed check: whether joints can turn as fast as a motion needs, and the message when they
 * cannot.
 */
final class JointSpeedCheck {
  /** Room for the mean speed of a frame, which may exceed the speeds at both of its ends. */
  private static final double MEAN_SPEED_TOLERANCE = 1.01;

  /** Times of its highest speed that a joint may be asked for where slowing down still helps. */
  private static final double BEYOND_SLOWING = 1 / ActiveTrajectory.MIN_SCALING;

  /** So near (rad) to being straight, elbow or wrist are what makes the joints turn fast. */
  private static final double NEAR_RAD = 0.15;

  private final double[] maxSpeed = new double[Joints.COUNT];

  JointSpeedCheck(ArmDescription arm) {
    for (int i = 0; i < Joints.COUNT; i++) {
      maxSpeed[i] = arm.joints().get(i).maxSpeedRadPerS();
    }
  }

  /** How much of what they can do the joints do at these speeds; 1 for all that one can. */
  double share(JointNumbers speedRadPerS) {
    double[] speed = speedRadPerS.numbers();
    double share = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      share = Math.max(share, Math.abs(speed[i]) / maxSpeed[i]);
    }
    return share;
  }

  /** A point of a path, reached from {@code before} within a frame. */
  Optional<MotionFailure> onPath(double[] before, MotionSample sample, double scaling) {
    for (int i = 0; i < Joints.COUNT; i++) {
      if (Math.abs(sample.position[i] - before[i]) > Math.PI) {
        return Optional.of(rangeEnds(i, before[i]));
      }
      double moved = Math.abs(sample.position[i] - before[i]) / FrameTime.FRAME_S;
      double needed = Math.max(moved, Math.abs(sample.speed[i]) * scaling);
      if (needed > BEYOND_SLOWING * maxSpeed[i]) {
        return Optional.of(singular(before, i, needed));
      }
      if (!(needed <= maxSpeed[i] * MEAN_SPEED_TOLERANCE)) {
        return Optional.of(tooFast(i, needed, text("pathTooFast")));
      }
    }
    return Optional.empty();
  }

  /** Speeds of a target that offsets carry aside. */
  Optional<MotionFailure> carried(JointNumbers speedRadPerS) {
    double[] speed = speedRadPerS.numbers();
    for (int i = 0; i < Joints.COUNT; i++) {
      double needed = Math.abs(speed[i]);
      if (!(needed <= maxSpeed[i] * MEAN_SPEED_TOLERANCE)) {
        return Optional.of(tooFast(i, needed, text("carriedTooSuddenly")));
      }
    }
    return Optional.empty();
  }

  /** The path continues only where the joint stands a turn further back. */
  private static MotionFailure rangeEnds(int joint, double atRad) {
    return new MotionFailure(
        MotionFailure.RANGE_ENDS, text("rangeEnds", joint, FloatText.of(atRad)));
  }

  private MotionFailure tooFast(int joint, double needed, String why) {
    return new MotionFailure(
        MotionFailure.TOO_FAST,
        text("tooFast", joint, FloatText.of(needed), FloatText.of(maxSpeed[joint]), why));
  }

  /** The path needs a joint to turn faster than any slowing down helps against. */
  MotionFailure singular(MotionSample sample) {
    int fastest = 0;
    for (int i = 1; i < Joints.COUNT; i++) {
      if (Math.abs(sample.speed[i]) > Math.abs(sample.speed[fastest])) {
        fastest = i;
      }
    }
    return singular(sample.position, fastest, Math.abs(sample.speed[fastest]));
  }

  /** As it gets closer to the singularity the speed grows without end, and says nothing then. */
  private MotionFailure singular(double[] q, int joint, double speed) {
    double most = BEYOND_SLOWING * maxSpeed[joint];
    String needed = speed > most ? text("moreThan", FloatText.of(most)) : FloatText.of(speed);
    return new MotionFailure(
        MotionFailure.SINGULARITY,
        text(straightElbow(q) ? "singularElbow" : "singular", where(q), joint, needed));
  }

  private static boolean straightElbow(double[] q) {
    return Math.abs(Math.sin(q[2])) < NEAR_RAD;
  }

  private static String where(double[] q) {
    if (straightElbow(q)) {
      return text("straightElbow");
    }
    return Math.abs(Math.sin(q[4])) < NEAR_RAD ? text("straightWrist") : text("nearSingularity");
  }
}
