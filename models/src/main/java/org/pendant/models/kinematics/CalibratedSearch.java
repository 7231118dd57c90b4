package org.pendant.models.kinematics;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;

/**
 * Solutions of a calibrated arm, found from those of the nominal one.
 *
 * <p>Away from singularities each nominal solution leads to one of the calibrated arm. At a
 * singularity two of them meet, and calibration decides whether they part or vanish; there the
 * search also starts to both sides.
 */
final class CalibratedSearch {
  /** Sine of joint 3 or 5 below which the search starts to both sides, too. */
  private static final double NEARLY_SINGULAR = 0.1;

  /** How far to the side (rad). */
  private static final double ASIDE = 0.2;

  private final Refinement refinement;
  private final double[] start = new double[Joints.COUNT];

  CalibratedSearch(ArmDescription arm) {
    refinement = new Refinement(arm);
  }

  /** Looks next to the joints that solutions are to be near to. */
  void lookNear(double[] target, Candidates candidates) {
    System.arraycopy(candidates.near(), 0, start, 0, Joints.COUNT);
    look(target, candidates);
  }

  /** Looks next to a nominal solution; the nearest miss is a candidate, too. */
  void lookAround(ClosedForm form, double[] target, Candidates candidates) {
    form.copyTo(start);
    candidates.keepIfNew(refined(target, candidates));
    if (form.tooClose) {
      lookAside(0, target, candidates);
    }
    if (Math.abs(Math.sin(start[2])) < NEARLY_SINGULAR) {
      lookAside(2, target, candidates);
    }
    if (Math.abs(Math.sin(start[4])) < NEARLY_SINGULAR) {
      // joints 4 and 6 may have to be anywhere: their axes are nearly parallel
      for (int quarter = 0; quarter < 4; quarter++) {
        lookAside(4, target, candidates);
        start[3] -= 0.5 * Math.PI * Math.signum(Math.cos(start[4]));
        start[5] += 0.5 * Math.PI;
      }
    }
  }

  /** Follows a path from {@code q}; true if the joints that reach the target were found there. */
  boolean follow(double[] target, double[] q) {
    return refinement.refine(target, q, InverseKinematics.DEFAULT_ERROR);
  }

  private void lookAside(int joint, double[] target, Candidates candidates) {
    double middle = start[joint];
    start[joint] = middle - ASIDE;
    look(target, candidates);
    start[joint] = middle + ASIDE;
    look(target, candidates);
    start[joint] = middle;
  }

  private void look(double[] target, Candidates candidates) {
    if (refined(target, candidates)) {
      candidates.keepIfNew(true);
    }
  }

  private boolean refined(double[] target, Candidates candidates) {
    double[] q = candidates.next();
    System.arraycopy(start, 0, q, 0, Joints.COUNT);
    return refinement.refine(target, q, InverseKinematics.DEFAULT_ERROR);
  }
}
