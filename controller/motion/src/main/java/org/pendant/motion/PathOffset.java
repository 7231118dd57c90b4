package org.pendant.motion;

/**
 * Path offset: what displaces the TCP from the path that moves follow: a conveyor, an offset, a
 * force. Called once a frame while it is active, paused or not, but not while a safety function
 * holds the arm; allocates nothing.
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

  /** A safety function brings the arm to rest: what this carries has no speed any more. */
  default void rest() {}

  /**
   * The path is put anew so that the target stays where it is. Answers where the path has to be for
   * {@link #apply} to carry the TCP to where it is; an offset that forgets instead what it has
   * carried so far leaves it as it is.
   *
   * @param tcpInBase where the TCP is, without what offsets added after this one do; overwritten
   * @param framesAgo 0 for the last frame, 1 for the one before
   */
  default void rebase(double[] tcpInBase, int framesAgo) {}

  /** Nothing is carried any more; also because power is gone, or the program has ended. */
  void end();
}
