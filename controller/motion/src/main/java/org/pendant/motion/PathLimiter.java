package org.pendant.motion;

/**
 * Path limiter: keeps a motion below limits that its plan does not know, by letting time on its
 * path run slower.
 */
@FunctionalInterface
public interface PathLimiter {
  /** Limits nothing. No lambda: the AOT cache holds none that is made with an interface. */
  PathLimiter NONE =
      new PathLimiter() {
        @Override
        public double largestScaling(double[] q, double[] qd) {
          return Double.POSITIVE_INFINITY;
        }
      };

  /**
   * How fast time on the path may run at a point of it. Allocates nothing and keeps no argument.
   *
   * @param q six joint positions, rad
   * @param qd six joint speeds when path time runs as fast as the clock, rad/s
   * @return the largest scaling allowed, not below 0; 1 or more where nothing limits
   */
  double largestScaling(double[] q, double[] qd);

  /**
   * The same where the caller knows already how the links stand.
   *
   * @param frames of the links in the base frame at {@code q}, as {@link
   *     org.pendant.models.kinematics.ForwardKinematics#frames} has them
   */
  default double largestScaling(double[] q, double[] qd, double[][] frames) {
    return largestScaling(q, qd);
  }
}
