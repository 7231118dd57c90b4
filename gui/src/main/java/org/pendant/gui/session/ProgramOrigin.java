package org.pendant.gui.session;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import org.pendant.controller.Reply;
import org.pendant.controller.machine.ProgramEvent;
import org.pendant.controller.state.ControllerState;

/** Tells the programs that the session has started from those that others have sent. */
final class ProgramOrigin implements FrameListener {
  /** Set and cleared by the frame loop only: a reply comes in the frame that starts the program. */
  private boolean expected;

  private final AtomicLong strangers = new AtomicLong();
  private volatile boolean strangerLast;

  /** The program that {@code asked} starts is the session's own. */
  CompletableFuture<Reply> expect(CompletableFuture<Reply> asked) {
    return asked.whenComplete((reply, fault) -> expected |= reply instanceof Reply.Done);
  }

  @Override
  public void frame(ControllerState state) {
    for (ProgramEvent each : state.newProgramEvents()) {
      if (each instanceof ProgramEvent.Started) {
        strangerLast = !expected;
        if (strangerLast) {
          strangers.incrementAndGet();
        }
        expected = false;
      }
    }
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
