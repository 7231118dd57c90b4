package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Path of the arm from one point to another, without time. A point on it is given by how far it is
 * from the start, in the path's own unit: rad of the joint that turns farthest, or m of the TCP.
 *
 * <p>Keeps scratch space: one user at a time, and questions best continue from one to the next.
 */
public interface MotionPath {
  /** How long it is. */
  double length();

  /**
   * A point on the path.
   *
   * @param at 0 to {@link #length}
   * @param rate first derivative of {@code at} by time, per s
   * @param rate2 second derivative, per s²
   * @param sample overwritten
   * @return why there is no such point, empty when there is
   */
  Optional<MotionFailure> sample(double at, double rate, double rate2, MotionSample sample);

  /** Joint positions at its start, rad. */
  Joints begin();

  /** Joint positions at its end, rad, as far as they can be told without going there. */
  Joints end();

  /** Pose of the TCP at the end, in the base frame. */
  Pose waypoint();

  /** The TCP that the path was made for, in the flange frame. */
  Pose tcpInFlange();

  /**
   * The part of the path up to a point of it, for a move that is cut short.
   *
   * @param at above 0, at most {@link #length}
   * @return empty if moves on such a path are not cut short
   */
  default Optional<MotionPath> upTo(double at) {
    return Optional.empty();
  }

  /**
   * How far from the end the path comes into a sphere around the end for good.
   *
   * @param radiusM of the sphere, m, 0 or more
   * @return at most {@link #length}
   */
  double lengthWithinEnd(double radiusM);

  /** How far from the start the path leaves a sphere around the start for the first time. */
  double lengthWithinBegin(double radiusM);

  /** The highest rate that no joint is too slow for, as far as that is known beforehand. */
  double fastestRate();

  /** The highest change of the rate that the arm can do, per s², as far as that is known. */
  default double strongestRate2() {
    return Double.POSITIVE_INFINITY;
  }

  /** What keeps a move on it within the means of the arm. */
  default PathLimits pathLimits() {
    return PathLimits.UNLIMITED;
  }

  /** The acceleration across the path for a rate of 1; 0 for one that does not bend. */
  default double bending() {
    return 0;
  }
}
