package org.pendant.controller.motion;

/**
 * What carries the TCP aside from the path that moves follow: a conveyor, an offset, a force.
 * Called once a frame while it is active, paused or not; allocates nothing.
 */
public interface PathOffset {
  /** Whether it carries the TCP now. */
  boolean active();

  /**
   * Changes where the TCP is to be in this frame.
   *
   * @param tcpInBase the transformation (see {@link org.pendant.models.pose.Transforms}) of the
   *     TCP, with what other offsets have done before; overwritten
   */
  void apply(double[] tcpInBase);

  /** Power is gone and the arm rests elsewhere: nothing is carried any more. */
  void end();
}
