package org.pendant.desktop.session;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import org.pendant.controller.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramEvent;

/** Tells the programs that the session has started from those that others have sent. */
final class ProgramOrigin implements FrameListener {
  /** Starts that can be gone back to. */
  private static final int MAX_STARTS = 10_000;

  /** Set and cleared by the frame loop only: a reply comes in the frame that starts the program. */
  private boolean expected;

  /** The newest starts, for going back; used by whoever drives the frames. */
  private final Deque<Start> starts = new ArrayDeque<>();

  private final AtomicLong strangers = new AtomicLong();
  private volatile boolean strangerLast;

  /** A program started in a frame. */
  private record Start(long frame, boolean stranger) {}

  /** The program that {@code asked} starts is the session's own. */
  CompletableFuture<Reply> expect(CompletableFuture<Reply> asked) {
    return asked.whenComplete((reply, fault) -> expected |= reply instanceof Reply.Done);
  }

  @Override
  public void frame(ControllerState state) {
    for (ProgramEvent each : state.newProgramEvents()) {
      if (each instanceof ProgramEvent.Started) {
        strangerLast = !expected;
        starts.addLast(new Start(state.frame(), strangerLast));
        if (starts.size() > MAX_STARTS) {
          starts.removeFirst();
        }
        if (strangerLast) {
          strangers.incrementAndGet();
        }
        expected = false;
      }
    }
  }

  /**
   * Another controller takes the place of the present one and stands where that was in a frame; 0
   * for one that was just switched on. Nobody may drive either.
   */
  void goBack(long frame) {
    while (!starts.isEmpty() && starts.getLast().frame() > frame) {
      starts.removeLast();
    }
    expected = false;
    strangerLast = !starts.isEmpty() && starts.getLast().stranger();
  }

  /** How many of others have started. */
  long strangers() {
    return strangers.get();
  }

  /** Whether the one that started last was of others. */
  boolean strangerLast() {
    return strangerLast;
  }
}
