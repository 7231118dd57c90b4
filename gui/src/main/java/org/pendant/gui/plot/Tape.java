package org.pendant.gui.plot;

import java.util.concurrent.atomic.AtomicReferenceArray;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.session.FrameListener;

/**
 * The last two minutes of snapshots, one every 8 ms of robot time, whether anybody looks or not.
 * The frame loop alone writes; any thread reads. Snapshots are counted from 0 without gaps, also
 * across a restart of the controller.
 */
final class Tape implements FrameListener {
  /** Frames from one kept snapshot to the next: 125 a second. */
  static final int FRAMES_PER_SAMPLE = 4;

  /** Two minutes. */
  static final int KEPT = 120 * 125;

  private final AtomicReferenceArray<ControllerState> ring = new AtomicReferenceArray<>(KEPT);
  private volatile long end;

  @Override
  public void frame(ControllerState state) {
    if (state.frame() % FRAMES_PER_SAMPLE == 0) {
      ring.set((int) (end % KEPT), state);
      // written by this thread only, so nothing is lost between reading and writing
      long next = end + 1;
      end = next;
    }
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
}
