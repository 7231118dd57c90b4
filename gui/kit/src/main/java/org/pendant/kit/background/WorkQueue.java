package org.pendant.kit.background;

/** Where work is done that would hold up the window. Pieces of work come one after the other. */
public interface WorkQueue {

  /** Does {@code work} not before {@code delayMs} milliseconds have passed. */
  void run(int delayMs, Runnable work);
}
