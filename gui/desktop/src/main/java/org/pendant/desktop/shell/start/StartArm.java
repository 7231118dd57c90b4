package org.pendant.desktop.shell.start;

import java.util.function.Consumer;
import org.pendant.models.arm.Joints;

/**
 * Start of the arm: moves it to where a program moves first. One thread uses it, which is told how
 * it ends.
 */
public interface StartArm {

  /**
   * Has the arm go there by itself, slower than programs do.
   *
   * @param ended is told why the arm is not there, once it rests; empty text if it is
   */
  void go(Joints goalRad, Consumer<String> ended);

  /** Stops what {@link #go} has begun; {@code ended} is told nothing any more. */
  void stop();

  /** Has the arm go there as long as this is held. */
  void hold(Joints goalRad);

  /** Ends {@link #hold}. */
  void release();

  /** Why the arm did not go, or no further, when it was held last; empty if it did. */
  String heldBecause();
}
