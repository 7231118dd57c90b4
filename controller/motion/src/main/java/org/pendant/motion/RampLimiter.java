package org.pendant.motion;

/**
 * Ramp limiter: keeps changes of the speed on a path, such as pauses, within limits of their own.
 */
@FunctionalInterface
public interface RampLimiter {
  /** Limits nothing. */
  RampLimiter NONE = (last, own, before, wanted) -> wanted;

  /**
   * The scaling of a motion's time that may be reached within a frame. Allocates nothing.
   *
   * @param last where the frame begins, in the motion's own time
   * @param own where it leads to
   * @param before the scaling of the frame before, 0 to 1
   * @param wanted the scaling to come to, 0 to 1
   * @return a scaling between both
   */
  double reachableScaling(MotionSample last, MotionSample own, double before, double wanted);
}
