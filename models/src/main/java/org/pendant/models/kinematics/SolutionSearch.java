package org.pendant.models.kinematics;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;

/**
 * The search behind {@link InverseKinematics}: all combinations of the closed form's decisions, or
 * only the one that continues a path; for a calibrated arm with Newton's method from there.
 */
final class SolutionSearch {
  /** Step in rad that no longer counts as continuing a path; a frame moves 0.006 rad. */
  private static final double LARGE_STEP = 0.3;

  /** Nearer than this, rad, no other shoulder is nearer if they are a quarter turn apart. */
  private static final double NEARER_SHOULDER = 0.7;

  private final ClosedForm form;
  private final JointRanges ranges;
  private final Candidates candidates;
  private final boolean nominal;
  private final CalibratedSearch calibrated;

  private double[] target;
  private double[] near;
  private boolean sawTooFar;
  private boolean sawTooFolded;

  /** Whether the closed form stands at what {@link #continueFrom} has found. */
  private boolean continued;

  /** The side of the shoulder that was nearer the last time, +1 or -1. */
  private int lastShoulder = 1;

  SolutionSearch(ArmDescription arm) {
    form = new ClosedForm(arm.dh());
    ranges = new JointRanges(arm.joints());
    candidates = new Candidates(ranges);
    nominal = arm.calibration().isNominal();
    calibrated = new CalibratedSearch(arm);
  }

  /** The joint positions within their ranges, whether they reach or come as near as they can. */
  Candidates collect(double[] flange, double[] nearQ) {
    target = flange;
    near = nearQ;
    continued = false;
    candidates.start(near);
    sawTooFar = false;
    sawTooFolded = false;
    if (!nominal) {
      calibrated.lookNear(target, candidates);
    }
    form.aimAt(target);
    form.shoulder(1, free(0));
    collectWrists();
    if (!form.oneShoulder()) {
      form.shoulder(-1, free(0));
      collectWrists();
    }
    return candidates;
  }

  private void collectWrists() {
    form.wrist(free(5));
    collectElbows();
    if (!form.wristFree) {
      form.otherWrist();
      collectElbows();
    }
  }

  private void collectElbows() {
    form.elbow(free(1));
    sawTooFar |= form.tooFar;
    sawTooFolded |= form.tooFolded;
    collectOne();
    if (!form.oneElbow()) {
      form.otherElbow();
      collectOne();
    }
  }

  /** Where joint i goes if the pose leaves it free. */
  private double free(int i) {
    return ranges.nearest(i, near[i]);
  }

  private void collectOne() {
    if (nominal) {
      form.copyTo(candidates.next());
      candidates.keep(form.reaches(InverseKinematics.DEFAULT_ERROR), form.wristFree);
    } else {
      calibrated.lookAround(form, target, candidates);
    }
  }

  /**
   * Sets {@code q} to the solution next to {@code nearQ}; false, and undefined, if not close by.
   */
  boolean continueFrom(double[] flange, double[] nearQ, double[] q) {
    target = flange;
    near = nearQ;
    continued = false;
    boolean found = nominal ? decideNear(q) : refineNear(q);
    if (!found || !ranges.turnNear(q, near)) {
      return false;
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      if (!(Math.abs(q[i] - near[i]) <= LARGE_STEP)) {
        return false;
      }
    }
    continued = nominal;
    return true;
  }

  /**
   * Frames of the links at the joints that {@link #continueFrom} has just found.
   *
   * @return false if they are not known
   */
  boolean frames(double[][] frames) {
    if (continued) {
      form.frames(frames);
    }
    return continued;
  }

  private boolean refineNear(double[] q) {
    System.arraycopy(near, 0, q, 0, Joints.COUNT);
    return calibrated.follow(target, q);
  }

  /** Makes each decision of the closed form for the nearer side. */
  private boolean decideNear(double[] q) {
    form.aimAt(target);
    decideShoulder();
    form.wrist(free(5));
    double offset = wristOffset();
    if (!form.wristFree) {
      form.otherWrist();
      if (offset < wristOffset()) {
        form.otherWrist();
      }
    }
    form.elbow(free(1));
    if (JointRanges.offset(-form.q3, near[2]) < JointRanges.offset(form.q3, near[2])) {
      form.otherElbow();
    }
    form.copyTo(q);
    return form.reaches(InverseKinematics.DEFAULT_ERROR);
  }

  /** Takes the nearer shoulder, beginning with that of the last time: a path rarely changes it. */
  private void decideShoulder() {
    double free = free(0);
    form.shoulder(lastShoulder, free);
    double offset = JointRanges.offset(form.q1, near[0]);
    if (offset < NEARER_SHOULDER && form.shouldersFarApart()) {
      return;
    }
    form.shoulder(-lastShoulder, free);
    double other = JointRanges.offset(form.q1, near[0]);
    // what is exactly between them is said to be behind the axis
    if (offset < other || (offset == other && lastShoulder < 0)) {
      form.shoulder(lastShoulder, free);
    } else {
      lastShoulder = -lastShoulder;
    }
  }

  private double wristOffset() {
    return JointRanges.offset(form.q5, near[4]) + JointRanges.offset(form.q6, near[5]);
  }

  /** Why no candidate of the last {@link #collect} reaches. */
  InverseResult.Cause cause() {
    if (form.tooClose) {
      return InverseResult.Cause.TOO_CLOSE_TO_BASE_AXIS;
    }
    if (candidates.isEmpty() || (candidates.sawOutsideRange() && !sawTooFar && !sawTooFolded)) {
      return InverseResult.Cause.JOINT_LIMITS;
    }
    if (sawTooFar) {
      return InverseResult.Cause.TOO_FAR;
    }
    return sawTooFolded ? InverseResult.Cause.TOO_FOLDED : InverseResult.Cause.TOLERANCE;
  }
}
