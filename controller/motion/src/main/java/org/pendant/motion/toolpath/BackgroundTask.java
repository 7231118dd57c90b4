package org.pendant.motion.toolpath;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import org.pendant.motion.PlanningException;

/**
 * Background task: work that takes too long for a frame, done by another thread. In virtual time it
 * ends in the same frame of every run, however fast the machine is, since the frame waits for it.
 * By the wall clock the frames continue meanwhile.
 *
 * @param <T> what comes of it
 */
public final class BackgroundTask<T> {
  private final FutureTask<T> task;
  private final boolean virtualTime;
  private long framesLeft;

  private BackgroundTask(Callable<T> work, long frames, boolean virtualTime) {
    task = new FutureTask<>(work);
    framesLeft = frames;
    this.virtualTime = virtualTime;
  }

  /**
   * Begins.
   *
   * @param frames after how many it is over at the earliest, 1 or more
   * @param virtualTime whether runs must repeat exactly
   */
  static <T> BackgroundTask<T> begin(Callable<T> work, long frames, boolean virtualTime) {
    BackgroundTask<T> made = new BackgroundTask<>(work, frames, virtualTime);
    Thread.ofVirtual().name("toolpath").start(made.task);
    return made;
  }

  /** Asked once a frame: whether it is over. */
  public boolean over() {
    framesLeft = Math.max(0, framesLeft - 1);
    return framesLeft == 0 && (virtualTime || task.isDone());
  }

  /**
   * What came of it, once it is over.
   *
   * @throws PlanningException when it has failed
   */
  public T result() throws PlanningException {
    boolean interrupted = false;
    try {
      while (true) {
        try {
          return task.get();
        } catch (InterruptedException e) {
          // the thread that closes the controller gets to it after this frame; the work is bounded
          interrupted = true;
        }
      }
    } catch (ExecutionException e) {
      if (e.getCause() instanceof PlanningException failure) {
        throw failure;
      }
      throw new IllegalStateException("toolpath", e.getCause());
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }
}
