package org.pendant.desktop.plot;

import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.FrameListener;
import org.pendant.script.variables.TracedVariables;

/**
 * Plot history: the last two minutes, whether their screen is shown or not: a snapshot every 8 ms
 * of robot time, and the traced script variables of every frame. The frame loop alone writes; any
 * thread reads. Snapshots and frames are counted from 0 without gaps, also across a restart of the
 * controller.
 */
final class PlotHistory implements FrameListener {
  /** Frames from one kept snapshot to the next: 125 a second. */
  static final int FRAMES_PER_SAMPLE = 4;

  /** Snapshots in two minutes. */
  static final int KEPT = 120 * 125;

  /** Frames in two minutes. */
  static final int KEPT_FRAMES = 120 * 500;

  private final AtomicReferenceArray<ControllerState> ring = new AtomicReferenceArray<>(KEPT);
  private final AtomicReferenceArray<TracedVariables> traced =
      new AtomicReferenceArray<>(KEPT_FRAMES);
  private final AtomicLongArray times = new AtomicLongArray(KEPT_FRAMES);
  private volatile long end;
  private volatile long endFrame;
  private long newest = -1;

  // Each count is written by one thread only, so nothing is lost between reading and writing it.

  @Override
  public void frame(ControllerState state) {
    if (state.frame() == newest) {
      // a debugger has paused the program: no time has passed
      return;
    }
    newest = state.frame();
    if (state.frame() % FRAMES_PER_SAMPLE == 0) {
      ring.setPlain((int) (end % KEPT), state);
      long next = end + 1;
      end = next;
    }
    int slot = (int) (endFrame % KEPT_FRAMES);
    traced.setPlain(slot, state.traced());
    times.setPlain(slot, Double.doubleToRawLongBits(state.timeS()));
    long next = endFrame + 1;
    endFrame = next;
  }

  /** Number of the oldest snapshot that is certainly kept. */
  long first() {
    // the writer may be about to replace the oldest ones
    return Math.max(0, end - KEPT + KEPT / 16);
  }

  /** One more than the number of the newest. */
  long end() {
    return end;
  }

  /** Snapshot {@code number}, from {@link #first} to below {@link #end}. */
  ControllerState at(long number) {
    return ring.get((int) (number % KEPT));
  }

  /** Number of the oldest frame that is certainly kept. */
  long firstFrame() {
    return Math.max(0, endFrame - KEPT_FRAMES + KEPT_FRAMES / 16);
  }

  /** One more than the number of the newest frame. */
  long endFrame() {
    return endFrame;
  }

  /** Time of frame {@code number}, s, from {@link #firstFrame} to below {@link #endFrame}. */
  double timeS(long number) {
    return Double.longBitsToDouble(times.get((int) (number % KEPT_FRAMES)));
  }

  /** The script variables that were traced in frame {@code number}. */
  TracedVariables traced(long number) {
    return traced.get((int) (number % KEPT_FRAMES));
  }
}
