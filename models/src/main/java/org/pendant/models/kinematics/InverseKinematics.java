package org.pendant.models.kinematics;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Transforms;

/**
 * Inverse kinematics: from the pose of the flange to joint positions, in closed form (manual 16.15,
 * 16.16).
 *
 * <p>A pose has up to eight solutions, and each joint may make a full turn more where its range
 * allows. Every joint is turned as near as its range permits to the position it is asked to be near
 * to, and of the eight the one with the smallest sum of squared joint differences is the closest.
 * Every solution given has been checked with the forward kinematics.
 *
 * <p>What happens at the {@linkplain Singularity singularities}:
 *
 * <ul>
 *   <li>wrist (joint 5 at 0 or pi): the axes of joints 4 and 6 are parallel and a pose has a whole
 *       line of solutions. Joint 6 keeps the position it is to be near to, or the nearest in its
 *       range, or, if the arm cannot reach with that, turns by as little as lets it; one solution
 *       stands for the line, and if its joint 4 finds no place in its range, there is none.
 *   <li>elbow (joint 3 at 0, or at pi if the range allows): the two elbows coincide and are given
 *       once if equal to the last bit. Nothing is free.
 *   <li>shoulder (the wrist as near to the base axis as its offset permits): the two shoulders
 *       coincide, likewise. Nothing is free, unless the offset is zero: then joint 1 keeps the
 *       position it is to be near to, as joint 2 does on an arm with upper arm and forearm of equal
 *       length that folds back onto the shoulder.
 * </ul>
 *
 * <p>A calibrated arm has no closed form. Newton's method then leads from each solution of the
 * nominal arm, and from the position to be near to, to one of the calibrated arm; those that meet
 * are given once, and the {@value #MAX_SOLUTIONS} closest if there are more. What is certain: every
 * solution given has been checked with the calibrated forward kinematics, and joints that reach the
 * pose are found when asked for near to themselves, singular or not. What tests bear out: with
 * every delta up to 1 mm or 1 mrad, and links shifted by 5 m along axes 2 and 3 and back, none is
 * missed whose measures of {@link Singularity} all exceed 0.05 (0.2 if the shifts are 2 m and the
 * axes tilted by 10 mrad). Closer to a singularity, solutions far from the position to be near to
 * may be missing, and no joint counts as free.
 *
 * <p>An object keeps scratch space between calls: it must not be used by two threads at once.
 */
public final class InverseKinematics {
  /** Largest error in m and rad that URScript allows unless told otherwise (manual 16.15). */
  public static final double DEFAULT_ERROR = 1e-10;

  /** Most solutions a pose can have, full turns aside. */
  public static final int MAX_SOLUTIONS = 8;

  private final ForwardKinematics forward;
  private final SolutionSearch search;

  private final double[] target = new double[Transforms.SIZE];
  private final double[] reached = new double[Transforms.SIZE];
  private final double[] near = new double[Joints.COUNT];

  /** Inverse kinematics of an arm, its joint ranges and its calibration included. */
  public InverseKinematics(ArmDescription arm) {
    forward = new ForwardKinematics(arm);
    search = new SolutionSearch(arm);
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
   * met, except by a calibrated arm, whose nearest miss has a little of both errors.
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
    Candidates candidates = search(flange, qNear);
    PoseError least = new PoseError(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    for (int i = candidates.takeClosest(); i >= 0; i = candidates.takeClosest()) {
      forward.flange(candidates.q(i), reached);
      PoseError error = PoseError.between(reached, target);
      if (error.within(maxPositionErrorM, maxOrientationErrorRad)) {
        Joints q = Joints.of(candidates.q(i));
        return new InverseResult.Reached(q, error, candidates.wristFree(i));
      }
      if (error.positionM() < least.positionM()) {
        least = error;
      }
    }
    return new InverseResult.Unreachable(search.cause(), least);
  }

  /**
   * All solutions within the default errors, closest to {@code qNear} first.
   *
   * @param flange pose of the flange in the base frame
   * @throws IllegalArgumentException if the pose or {@code qNear} is not finite
   */
  public List<Joints> all(Pose flange, Joints qNear) {
    Candidates candidates = search(flange, qNear);
    List<Joints> solutions = new ArrayList<>(MAX_SOLUTIONS);
    int i = candidates.takeClosestExact();
    while (i >= 0 && solutions.size() < MAX_SOLUTIONS) {
      solutions.add(Joints.of(candidates.q(i)));
      i = candidates.takeClosestExact();
    }
    return solutions;
  }

  /**
   * All solutions within the default errors, closest to {@code qNear} first. Allocates nothing.
   *
   * @param flange transformation of the flange in the base frame; one that is not finite, or whose
   *     matrix is none of a rotation, has no solution
   * @param qNear six joint positions, rad; must be finite
   * @param solutions {@value #MAX_SOLUTIONS} rows of six joint positions in rad, the first of them
   *     overwritten
   * @return how many there are
   */
  public int allInto(double[] flange, double[] qNear, double[][] solutions) {
    System.arraycopy(flange, 0, target, 0, Transforms.SIZE);
    System.arraycopy(qNear, 0, near, 0, Joints.COUNT);
    Candidates candidates = search.collect(target, near);
    int count = 0;
    int i = candidates.takeClosestExact();
    while (i >= 0 && count < MAX_SOLUTIONS) {
      System.arraycopy(candidates.q(i), 0, solutions[count], 0, Joints.COUNT);
      count++;
      i = candidates.takeClosestExact();
    }
    return count;
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
    if (search.continueFrom(target, near, q)) {
      return true;
    }
    Candidates candidates = search.collect(target, near);
    int i = candidates.takeClosestExact();
    if (i >= 0) {
      System.arraycopy(candidates.q(i), 0, q, 0, Joints.COUNT);
    } else {
      System.arraycopy(near, 0, q, 0, Joints.COUNT);
    }
    return i >= 0;
  }

  /**
   * The frames of the links at the joints that {@link #track} has just found, which knows their
   * sines and cosines already; allocates nothing.
   *
   * @param q these joints, six positions, rad
   * @param frames six rows of twelve numbers, overwritten, as {@link ForwardKinematics#frames} has
   *     them
   */
  public void trackedFrames(double[] q, double[][] frames) {
    if (!search.frames(frames)) {
      forward.frames(q, frames);
    }
  }

  /** The error that is left between a wanted pose of the flange and the one {@code q} gives. */
  public PoseError poseError(Joints q, Pose flange) {
    double[] wanted = new double[Transforms.SIZE];
    double[] given = new double[Transforms.SIZE];
    Transforms.of(flange, wanted);
    forward.flange(q.toArray(), given);
    return PoseError.between(given, wanted);
  }

  private Candidates search(Pose flange, Joints qNear) {
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
    return search.collect(target, near);
  }

  private static void requireAllowed(String name, double value) {
    if (!(value >= 0)) {
      throw new IllegalArgumentException(name + ": is " + value + ", must not be negative");
    }
  }
}
