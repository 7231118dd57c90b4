package org.pendant.desktop.session;

import static org.pendant.desktop.session.SessionTexts.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramEvent;

/**
 * Program origin: tells the programs that the session has started from those that others have sent.
 */
final class ProgramOrigin implements FrameListener {
  private static final Reply NOT_YET = new Reply.Busy(text("notAnsweredYet"));

  /** Starts that can be gone back to. */
  private static final int MAX_STARTS = 10_000;

  private final ReentrantLock lock = new ReentrantLock();

  /**
   * What the session has asked for and no frame has shown yet, oldest first; guarded by {@code
   * lock}. A reply is there before the frame that starts its program is seen.
   */
  private final List<CompletableFuture<Reply>> asked = new ArrayList<>();

  /** The newest starts, for going back; used by the thread that drives the frames. */
  private final Deque<Start> starts = new ArrayDeque<>();

  private final AtomicLong strangers = new AtomicLong();
  private volatile boolean strangerLast;

  /** A program started in a frame. */
  private record Start(long frame, boolean stranger) {}

  /**
   * The program that {@code start} asks for is the session's own. It is expected before a frame can
   * show it, however soon that comes.
   *
   * @param start must not wait
   */
  CompletableFuture<Reply> expect(Supplier<CompletableFuture<Reply>> start) {
    lock.lock();
    try {
      asked.removeIf(each -> each.isDone() && !started(each));
      CompletableFuture<Reply> reply = start.get();
      asked.add(reply);
      return reply;
    } finally {
      lock.unlock();
    }
  }

  private static boolean started(CompletableFuture<Reply> reply) {
    return reply.getNow(NOT_YET) instanceof Reply.Done;
  }

  /** Whether the program that has just started is the session's own. */
  private boolean own() {
    lock.lock();
    try {
      return asked.removeIf(ProgramOrigin::started);
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void frame(ControllerState state) {
    for (ProgramEvent each : state.newProgramEvents()) {
      if (each instanceof ProgramEvent.Started) {
        strangerLast = !own();
        starts.addLast(new Start(state.frame(), strangerLast));
        if (starts.size() > MAX_STARTS) {
          starts.removeFirst();
        }
        if (strangerLast) {
          strangers.incrementAndGet();
        }
      }
    }
  }

  /**
   * Another controller takes the place of the present one and stands where that was in a frame; 0
   * for one that was just switched on. No thread may drive either.
   */
  void goBack(long frame) {
    while (!starts.isEmpty() && starts.getLast().frame() > frame) {
      starts.removeLast();
    }
    lock.lock();
    try {
      asked.clear();
    } finally {
      lock.unlock();
    }
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
