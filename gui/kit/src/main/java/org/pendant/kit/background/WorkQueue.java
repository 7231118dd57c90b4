package org.pendant.kit.background;

/** Work queue: does work that would block the window. Pieces of work come one after the other. */
public interface WorkQueue {

  /** Does {@code work} not before {@code delayMs} milliseconds have passed. */
  void run(int delayMs, Runnable work);
}
