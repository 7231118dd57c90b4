package org.pendant.controller;

import java.util.function.BooleanSupplier;

/** Paces the frames. */
public sealed interface Clock permits SteerableClock, VirtualClock, WallClock {
  /**
   * Waits until the next frame is due.
   *
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  default void awaitFrame() throws InterruptedException {
    awaitFrame(() -> false);
  }

  /**
   * As {@link #awaitFrame()}, but robot time goes no faster than the wall clock while somebody
   * outside is waited for, who knows no other time.
   *
   * @param waitsForOutside asked only where it matters
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  void awaitFrame(BooleanSupplier waitsForOutside) throws InterruptedException;

  /** Time has stood still on purpose: the next frame is due whenever it comes. */
  void startAfresh();

  /**
   * By how much robot time has fallen behind the wall since the start, as frames came too late to
   * be caught up, ns; 0 for a clock that does not follow the wall. For the thread that waits.
   */
  long lostNs();
}
