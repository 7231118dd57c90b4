package org.pendant.models.kinematics;

import org.pendant.models.arm.Joints;

/** Inverse kinematics result: what a search for joint positions found. */
public sealed interface InverseResult {
  /**
   * Joint positions that reach the pose.
   *
   * @param q joint positions in rad, within the limits of the arm
   * @param error what is left between the wanted pose and that of {@code q}
   * @param wristFree true at the wrist singularity ({@link Singularity#WRIST}), where wrist 3 stays
   *     at the angle it is given or as near as the arm's reach lets it; the other singularities
   *     leave no choice, and so does a calibrated arm
   */
  record Reached(Joints q, PoseError error, boolean wristFree) implements InverseResult {}

  /**
   * No joint positions reach the pose within the allowed errors.
   *
   * @param cause why
   * @param leastError the error of the best attempt
   */
  record Unreachable(Cause cause, PoseError leastError) implements InverseResult {}

  /**
   * Why a pose is out of reach. A calibrated arm has the causes of the nominal one; where only the
   * calibrated arm falls short, by millimetres, it is {@link #TOLERANCE}.
   */
  enum Cause {
    /** Wrist 1 would have to be nearer to the axis of joint 1 than the offset of the wrist. */
    TOO_CLOSE_TO_BASE_AXIS("tooCloseToBaseAxis"),
    /** Farther from the shoulder than upper arm and forearm together. */
    TOO_FAR("tooFar"),
    /** Nearer to the shoulder than the folded arm comes. */
    TOO_FOLDED("tooFolded"),
    /** Every solution has a joint outside its range. */
    JOINT_LIMITS("jointLimits"),
    /** Reached, but not as exactly as was asked. */
    TOLERANCE("tolerance");

    private final String key;

    Cause(String key) {
      this.key = key;
    }

    /** The cause as part of a sentence. */
    public String text() {
      return KinematicsTexts.text(key);
    }
  }
}
