package org.pendant.models.kinematics;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Transforms;

/**
 * From the pose of the flange to joint positions, in closed form (manual 16.15, 16.16).
 *
 * <p>A pose has up to eight solutions, and each joint may make a full turn more where its range
 * allows. Every joint is turned as near as its range permits to the position it is asked to be near
 * to, and of the eight the one with the smallest sum of squared joint differences is the closest.
 * Every solution given has been checked with the forward kinematics.
 *
 * <p>At the wrist singularity (joint 5 at 0 or pi) the axes of joints 4 and 6 are parallel and a
 * pose has a whole line of solutions: joint 6 then keeps the position it is to be near to, or, if
 * the arm cannot reach with that, turns by as little as lets it. At the shoulder and elbow
 * singularities two solutions coincide and nothing is free.
 *
 * <p>An object keeps scratch space between calls: it must not be used by two threads at once.
 */
public final class InverseKinematics {
  /** Largest error in m and rad that URScript allows unless told otherwise (manual 16.15). */
  public static final double DEFAULT_ERROR = 1e-10;

  /** Most solutions a pose can have, full turns aside. */
  public static final int MOST_SOLUTIONS = 8;

  /** Step in rad beyond which {@link #track} looks at all solutions; a frame moves 0.006 rad. */
  private static final double LARGE_STEP = 0.3;

  /** A joint this much (rad) outside its range is moved to its end: rounding, not a violation. */
  private static final double LIMIT_ROUNDING = 1e-12;

  private static final double TURN = 2 * Math.PI;

  private static final double[] NONE = {};

  private final ForwardKinematics forward;
  private final ClosedForm form;
  private final double[] min = new double[Joints.COUNT];
  private final double[] max = new double[Joints.COUNT];

  private final double[] target = new double[Transforms.SIZE];
  private final double[] reached = new double[Transforms.SIZE];
  private final double[] near = new double[Joints.COUNT];
  private final double[][] candidates = new double[MOST_SOLUTIONS][Joints.COUNT];
  private final double[] distances = new double[MOST_SOLUTIONS];
  private final boolean[] wristFree = new boolean[MOST_SOLUTIONS];
  private int count;
  private boolean sawTooFar;
  private boolean sawTooFolded;
  private boolean sawOutsideLimits;

  /** Inverse kinematics of one arm, its joint ranges included. */
  public InverseKinematics(ArmDescription arm) {
    forward = new ForwardKinematics(arm.dh());
    form = new ClosedForm(arm.dh());
    for (int i = 0; i < Joints.COUNT; i++) {
      JointLimits limits = arm.joints().get(i);
      min[i] = limits.minRad();
      max[i] = limits.maxRad();
    }
  }

  /**
   * The solution closest to {@code qNear} within the default errors.
   *
   * @param flange pose of the flange in the base frame
   */
  public Optional<Joints> closest(Pose flange, Joints qNear) {
    return closest(flange, qNear, DEFAULT_ERROR);
  }

  /**
   * The solution closest to {@code qNear}.
   *
   * @param flange pose of the flange in the base frame
   * @param tolerance largest error allowed, in m for the position and rad for the orientation
   */
  public Optional<Joints> closest(Pose flange, Joints qNear, double tolerance) {
    return switch (find(flange, qNear, tolerance, tolerance)) {
      case InverseResult.Reached found -> Optional.of(found.q());
      case InverseResult.Unreachable none -> Optional.empty();
    };
  }

  /**
   * The solution closest to {@code qNear} for a pose of the TCP, within the default errors.
   *
   * @param tcp pose of the TCP in the base frame
   * @param tcpInFlange the TCP offset
   */
  public Optional<Joints> solve(Pose tcp, Pose tcpInFlange, Joints qNear) {
    return closest(flangeOf(tcp, tcpInFlange), qNear);
  }

  /** The pose of the flange that puts the TCP at {@code tcp}, both in the base frame. */
  public static Pose flangeOf(Pose tcp, Pose tcpInFlange) {
    return tcpInFlange.equals(Pose.ZERO) ? tcp : Poses.trans(tcp, Poses.inverse(tcpInFlange));
  }

  /**
   * The solution closest to {@code qNear}, or why there is none. A pose just out of reach is
   * reached as nearly as the arm can and counts if the errors allow it; the orientation is always
   * met.
   *
   * @param flange pose of the flange in the base frame
   * @param maxPositionErrorM largest distance allowed, m
   * @param maxOrientationErrorRad largest angle allowed, rad
   * @throws IllegalArgumentException if the pose or {@code qNear} is not finite, or an error is
   *     negative
   */
  public InverseResult find(
      Pose flange, Joints qNear, double maxPositionErrorM, double maxOrientationErrorRad) {
    requireAllowed("maxPositionError", maxPositionErrorM);
    requireAllowed("maxOrientationError", maxOrientationErrorRad);
    prepare(flange, qNear);
    PoseError least = new PoseError(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    for (int tried = 0; tried < count; tried++) {
      int i = nextClosest();
      forward.flange(candidates[i], reached);
      PoseError error = PoseError.between(reached, target);
      if (error.within(maxPositionErrorM, maxOrientationErrorRad)) {
        return new InverseResult.Reached(Joints.of(candidates[i]), error, wristFree[i]);
      }
      if (error.positionM() < least.positionM()) {
        least = error;
      }
      distances[i] = Double.POSITIVE_INFINITY;
    }
    return new InverseResult.Unreachable(cause(), least);
  }

  /**
   * All solutions within the default errors, closest to {@code qNear} first.
   *
   * @param flange pose of the flange in the base frame
   * @throws IllegalArgumentException if the pose or {@code qNear} is not finite
   */
  public List<Joints> all(Pose flange, Joints qNear) {
    prepare(flange, qNear);
    List<Joints> solutions = new ArrayList<>(count);
    for (int tried = 0; tried < count; tried++) {
      int i = nextClosest();
      if (reaches(candidates[i])) {
        solutions.add(Joints.of(candidates[i]));
      }
      distances[i] = Double.POSITIVE_INFINITY;
    }
    return solutions;
  }

  /**
   * Follows a path: replaces {@code q}, joint positions for a pose close by, by the solution that
   * continues them. Allocates nothing.
   *
   * <p>Each decision is made for the side nearer to {@code q}; only if a joint would jump are all
   * eight solutions compared.
   *
   * @param flange transformation of the flange in the base frame
   * @param q six joint positions in rad, overwritten if there is a solution
   * @return false if no solution lies within the default errors and the joint ranges
   */
  public boolean track(double[] flange, double[] q) {
    System.arraycopy(flange, 0, target, 0, Transforms.SIZE);
    System.arraycopy(q, 0, near, 0, Joints.COUNT);
    double[] candidate = candidates[0];
    boolean close = continueFrom(near, candidate);
    if (!close || !reaches(candidate)) {
      candidate = searchAll();
    }
    if (candidate.length == 0) {
      return false;
    }
    System.arraycopy(candidate, 0, q, 0, Joints.COUNT);
    return true;
  }

  /** The error that is left between a wanted pose of the flange and the one {@code q} gives. */
  public PoseError poseError(Joints q, Pose flange) {
    double[] wanted = new double[Transforms.SIZE];
    double[] given = new double[Transforms.SIZE];
    Transforms.of(flange, wanted);
    forward.flange(q.toArray(), given);
    return PoseError.between(given, wanted);
  }

  private void prepare(Pose flange, Joints qNear) {
    for (int i = 0; i < Pose.SIZE; i++) {
      if (!Double.isFinite(flange.get(i))) {
        throw new IllegalArgumentException(
            "inverse kinematics: pose is " + flange + ", must be finite");
      }
    }
    if (!qNear.isFinite()) {
      throw new IllegalArgumentException(
          "inverse kinematics: qnear is " + qNear + ", must be finite");
    }
    Transforms.of(flange, target);
    qNear.copyTo(near);
    collect();
  }

  /** Fills the candidates that lie within the joint ranges, unchecked otherwise. */
  private void collect() {
    count = 0;
    sawTooFar = false;
    sawTooFolded = false;
    sawOutsideLimits = false;
    form.aimAt(target);
    for (int shoulder = 1; shoulder >= (form.oneShoulder() ? 1 : -1); shoulder -= 2) {
      form.shoulder(shoulder, near[0]);
      collectWrists();
    }
  }

  private void collectWrists() {
    for (int wrist = 1; wrist >= -1; wrist -= 2) {
      form.wrist(wrist, near[5]);
      for (int elbow = 1; elbow >= -1; elbow -= 2) {
        form.elbow(elbow, near[1]);
        sawTooFar |= form.tooFar;
        sawTooFolded |= form.tooFolded;
        if (write(candidates[count])) {
          distances[count] = squaredDistance(candidates[count]);
          wristFree[count] = form.wristFree;
          count++;
        } else {
          sawOutsideLimits = true;
        }
        if (form.tooFar || form.tooFolded) {
          break; // both elbows are the same then
        }
      }
      if (form.wristFree) {
        break; // both wrists are the same then
      }
    }
  }

  /** Index of the candidate with the smallest distance left; the first of equals. */
  private int nextClosest() {
    int best = 0;
    for (int i = 1; i < count; i++) {
      if (distances[i] < distances[best]) {
        best = i;
      }
    }
    return best;
  }

  private boolean continueFrom(double[] from, double[] candidate) {
    form.aimAt(target);
    form.shoulder(1, from[0]);
    double other = offset(form.q1, from[0]);
    form.shoulder(-1, from[0]);
    if (other < offset(form.q1, from[0])) {
      form.shoulder(1, from[0]);
    }
    form.wrist(1, from[5]);
    other = offset(form.q5, from[4]) + offset(form.q6, from[5]);
    form.wrist(-1, from[5]);
    if (other < offset(form.q5, from[4]) + offset(form.q6, from[5])) {
      form.wrist(1, from[5]);
    }
    form.elbow(1, from[1]);
    other = offset(form.q3, from[2]);
    if (offset(-form.q3, from[2]) < other) {
      form.elbow(-1, from[1]);
    }
    if (!write(candidate)) {
      return false;
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      if (!(Math.abs(candidate[i] - from[i]) <= LARGE_STEP)) {
        return false;
      }
    }
    return true;
  }

  private double[] searchAll() {
    collect();
    for (int tried = 0; tried < count; tried++) {
      int i = nextClosest();
      if (reaches(candidates[i])) {
        return candidates[i];
      }
      distances[i] = Double.POSITIVE_INFINITY;
    }
    return NONE;
  }

  private boolean reaches(double[] q) {
    forward.flange(q, reached);
    return PoseError.position(reached, target) <= DEFAULT_ERROR
        && PoseError.orientation(reached, target) <= DEFAULT_ERROR;
  }

  /** Writes the solution of the closed form, turned near; false if a range forbids it. */
  private boolean write(double[] q) {
    q[0] = form.q1;
    q[1] = form.q2;
    q[2] = form.q3;
    q[3] = form.q4;
    q[4] = form.q5;
    q[5] = form.q6;
    for (int i = 0; i < Joints.COUNT; i++) {
      double turned = q[i] + TURN * Math.rint((near[i] - q[i]) / TURN);
      if (turned > max[i] + LIMIT_ROUNDING) {
        turned -= TURN * Math.ceil((turned - max[i] - LIMIT_ROUNDING) / TURN);
      } else if (turned < min[i] - LIMIT_ROUNDING) {
        turned += TURN * Math.ceil((min[i] - LIMIT_ROUNDING - turned) / TURN);
      }
      if (!(turned >= min[i] - LIMIT_ROUNDING && turned <= max[i] + LIMIT_ROUNDING)) {
        return false;
      }
      q[i] = Math.max(min[i], Math.min(max[i], turned));
    }
    return true;
  }

  private double squaredDistance(double[] q) {
    double sum = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      double difference = q[i] - near[i];
      sum += difference * difference;
    }
    return sum;
  }

  private InverseResult.Cause cause() {
    if (form.tooClose) {
      return InverseResult.Cause.TOO_CLOSE_TO_BASE_AXIS;
    }
    if (count == 0 || (sawOutsideLimits && !sawTooFar && !sawTooFolded)) {
      return InverseResult.Cause.JOINT_LIMITS;
    }
    if (sawTooFar) {
      return InverseResult.Cause.TOO_FAR;
    }
    return sawTooFolded ? InverseResult.Cause.TOO_FOLDED : InverseResult.Cause.TOLERANCE;
  }

  /** Distance in rad of two angles, full turns aside. */
  private static double offset(double a, double b) {
    double difference = a - b;
    return Math.abs(difference - TURN * Math.rint(difference / TURN));
  }

  private static void requireAllowed(String name, double value) {
    if (!(value >= 0)) {
      throw new IllegalArgumentException(name + ": is " + value + ", must not be negative");
    }
  }
}
