package org.pendant.controller.freedrive;

import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.Singularity;

/**
 * Singularity distance: how near the arm is to a singularity, in which it cannot be guided in every
 * direction (manual 15.21).
 */
public enum SingularityDistance {
  /** Far enough. */
  NORMAL,
  /** Near: locked axes begin to resist. */
  NEAR,
  /** Too near: it is hard to move. */
  TOO_CLOSE;

  /** Below this measure of a singularity the arm is near it; our choice. */
  static final double NEAR_MEASURE = 0.2;

  /** Below this measure it is too close; our choice. */
  static final double TOO_CLOSE_MEASURE = 0.08;

  /** The measure of the nearest singularity: 0 in it, about 1 far from it. */
  static double measure(DhLengths dh, Joints q) {
    double shoulder = Singularity.SHOULDER.measure(dh, q);
    double elbow = Singularity.ELBOW.measure(dh, q);
    double wrist = Singularity.WRIST.measure(dh, q);
    return Math.min(shoulder, Math.min(elbow, wrist));
  }

  /** What a measure means. */
  static SingularityDistance ofMeasure(double measure) {
    if (measure < TOO_CLOSE_MEASURE) {
      return TOO_CLOSE;
    }
    return measure < NEAR_MEASURE ? NEAR : NORMAL;
  }

  /** At joint positions, rad. */
  public static SingularityDistance at(DhLengths dh, Joints q) {
    return ofMeasure(measure(dh, q));
  }

  /** The number that {@code get_freedrive_status} gives: 0, 1 or 2. */
  public int code() {
    return switch (this) {
      case NORMAL -> 0;
      case NEAR -> 1;
      case TOO_CLOSE -> 2;
    };
  }
}
