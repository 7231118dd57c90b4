package org.pendant.controller;

import java.util.function.BooleanSupplier;

/** Clock of the frame loop: paces the frames. */
public sealed interface Clock permits SteerableClock, VirtualClock, WallClock {
  /** What is to be done next. */
  enum Due {
    /** A frame. */
    FRAME,
    /**
     * A frame whose time is over, since nobody needed it on time: what has arrived is for the
     * frames after it.
     */
    EARLIER_FRAME,
    /** Commands have arrived while time stands: they are carried out without a frame. */
    COMMANDS
  }

  /**
   * Waits until something is due.
   *
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  default Due awaitDue() throws InterruptedException {
    return awaitDue(() -> false);
  }

  /**
   * As {@link #awaitDue()}, but robot time goes no faster than the wall clock while a peer outside
   * is waited for, who knows no other time.
   *
   * @param waitsForOutside asked only where it matters
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  Due awaitDue(BooleanSupplier waitsForOutside) throws InterruptedException;

  /**
   * Says that a command has arrived; any thread. It comes into force with the next frame, if there
   * is one soon.
   */
  default void commandArrived() {}

  /**
   * Whether frames may be let become due and be run some together. Without a word they come one by
   * one; by now only a {@link SteerableClock} does otherwise.
   *
   * @param mayGather asked before each wait, by the thread that waits
   */
  default void gatherWhile(BooleanSupplier mayGather) {}

  /** Time has stood still on purpose: the next frame is due whenever it comes. */
  void startAfresh();

  /**
   * By how much robot time has fallen behind the wall since the start, as frames came too late to
   * be caught up, ns; 0 for a clock that does not follow the wall. For the thread that waits.
   */
  long lostNs();
}
