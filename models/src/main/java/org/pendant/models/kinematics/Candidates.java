package org.pendant.models.kinematics;

import org.pendant.models.arm.Joints;

/** The joint positions that one search found within the joint ranges; given out closest first. */
final class Candidates {
  /** More than {@link InverseKinematics#MAX_SOLUTIONS}: not every candidate reaches. */
  private static final int ROOM = 32;

  /** Largest difference (rad) at which two candidates of a numerical search are the same. */
  private static final double SAME = 1e-6;

  private final JointRanges ranges;
  private final double[] near = new double[Joints.COUNT];
  private final double[][] q = new double[ROOM][Joints.COUNT];
  private final double[] distances = new double[ROOM];
  private final boolean[] exact = new boolean[ROOM];
  private final boolean[] wristFree = new boolean[ROOM];
  private int count;
  private boolean sawOutsideRange;

  Candidates(JointRanges ranges) {
    this.ranges = ranges;
  }

  /** Begins a search next to joint positions. */
  void start(double[] nearQ) {
    System.arraycopy(nearQ, 0, near, 0, Joints.COUNT);
    count = 0;
    sawOutsideRange = false;
  }

  double[] near() {
    return near;
  }

  /** The place to write the next candidate to. */
  double[] next() {
    return q[count];
  }

  /**
   * Turns what was written to {@link #next} near and keeps it if the ranges allow.
   *
   * @param reaches whether it is known to reach the pose within the default errors
   */
  void keep(boolean reaches, boolean free) {
    double[] candidate = q[count];
    if (!ranges.turnNear(candidate, near)) {
      sawOutsideRange = true;
      return;
    }
    double sum = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      double difference = candidate[i] - near[i];
      sum += difference * difference;
    }
    distances[count] = sum;
    exact[count] = reaches;
    wristFree[count] = free;
    count++;
  }

  /** As {@link #keep}, unless the same is there already or there is no room. */
  void keepIfNew(boolean reaches) {
    if (count < ROOM - 1 && !isKnown(q[count])) {
      keep(reaches, false);
    }
  }

  private boolean isKnown(double[] candidate) {
    for (int k = 0; k < count; k++) {
      double largest = 0;
      for (int i = 0; i < Joints.COUNT; i++) {
        largest = Math.max(largest, JointRanges.offset(candidate[i], q[k][i]));
      }
      if (largest < SAME) {
        return true;
      }
    }
    return false;
  }

  /** Index of the closest candidate not yet taken, the first of equals; -1 if none is left. */
  int takeClosest() {
    int best = -1;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      if (distances[i] < least) {
        least = distances[i];
        best = i;
      }
    }
    if (best >= 0) {
      distances[best] = Double.POSITIVE_INFINITY;
    }
    return best;
  }

  /** As {@link #takeClosest}, among those known to reach. */
  int takeClosestExact() {
    int i = takeClosest();
    while (i >= 0 && !exact[i]) {
      i = takeClosest();
    }
    return i;
  }

  double[] q(int i) {
    return q[i];
  }

  boolean wristFree(int i) {
    return wristFree[i];
  }

  boolean isEmpty() {
    return count == 0;
  }

  /** True if a joint range ruled a candidate out. */
  boolean sawOutsideRange() {
    return sawOutsideRange;
  }
}
