package org.pendant.controller;

/** Paces the frames. */
public sealed interface Clock permits SteerableClock, VirtualClock, WallClock {
  /**
   * Waits until the next frame is due.
   *
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  void awaitFrame() throws InterruptedException;
}
