package org.pendant.controller.machine;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.pendant.controller.value.ScriptError;
import org.pendant.controller.value.Value;

/**
 * Gives each runnable thread of a program its share of a frame (manual 10.2). A debugger may hold
 * it within a frame; it goes on then exactly where it was.
 */
final class Scheduler {
  /**
   * Turns and calls that one thread may make in a frame: the computing time of its slice. It is
   * counted, not measured, so that every machine schedules alike.
   */
  static final int BUDGET = 50_000;

  /** How a frame left the program. */
  enum FrameResult {
    RUNNING,
    PAUSED,
    HALTED,
    FINISHED,
    /** In the middle of it, at a trap. */
    HELD
  }

  private final ProgramRun run;
  private final Processor processor;
  private final Predicate<ScriptThread> nextLine;
  private final Sentry sentry;
  private final List<ScriptThread> order = new ArrayList<>();
  private ScriptThread running;
  private boolean executing;
  private long frame;

  // where the round of the frame is
  private int next;
  private boolean progress;
  private boolean held;

  Scheduler(ProgramRun run, Processor processor, Predicate<ScriptThread> nextLine, Sentry sentry) {
    this.run = run;
    this.processor = processor;
    this.nextLine = nextLine;
    this.sentry = sentry;
  }

  /** A new thread, which has its turn after the others. */
  void add(ScriptThread thread) {
    thread.budget = BUDGET;
    order.add(thread);
  }

  /** Frames that the program has been running, pauses not counted. */
  long frame() {
    return frame;
  }

  /** Whether {@code thread} has its turn just now. */
  boolean isRunning(ScriptThread thread) {
    return running == thread;
  }

  /** The thread that executes something just now; empty between turns. */
  Optional<ScriptThread> executing() {
    return executing ? Optional.of(running) : Optional.empty();
  }

  /** Whether it is held within a frame. */
  boolean held() {
    return held;
  }

  /**
   * Runs every runnable thread until it waits, ends or has used its slice. Those with the largest
   * slice left over go first. Goes on with the frame that it was held in.
   */
  FrameResult advance() throws ThreadFailure {
    if (!held) {
      begin();
    }
    return rounds();
  }

  private void begin() {
    frame++;
    if (order.size() > 1) {
      order.removeIf(ScriptThread::ended);
      order.sort(
          Comparator.comparing((ScriptThread t) -> !t.critical)
              .thenComparing(Comparator.comparingInt((ScriptThread t) -> t.budget).reversed())
              .thenComparingInt(ScriptThread::id));
    }
    for (int i = 0; i < order.size(); i++) {
      order.get(i).budget = BUDGET;
    }
    next = 0;
    progress = false;
  }

  /** Goes round the threads until none can do more in this frame. */
  private FrameResult rounds() throws ThreadFailure {
    while (true) {
      // threads started meanwhile stand at the end and get their turn too
      for (; next < order.size(); next++) {
        ScriptThread thread = order.get(next);
        if (!held && !ready(thread)) {
          continue;
        }
        held = false;
        progress = true;
        FrameResult result = turn(thread);
        held = result == FrameResult.HELD;
        if (result != FrameResult.RUNNING) {
          return result;
        }
        if (thread.critical && thread.state == ScriptThread.State.RUNNABLE) {
          // out of its slice inside a critical section: nobody runs until it goes on
          return FrameResult.RUNNING;
        }
      }
      if (!progress) {
        return FrameResult.RUNNING;
      }
      next = 0;
      progress = false;
    }
  }

  private FrameResult turn(ScriptThread thread) throws ThreadFailure {
    if (thread.ended()) {
      // killed while it was held
      return FrameResult.RUNNING;
    }
    switch (execute(thread)) {
      case WAITING -> {
        thread.state = ScriptThread.State.WAITING;
        thread.polledFrame = frame;
        thread.budget = 0;
      }
      case EXHAUSTED -> thread.budget = 0;
      case INTERPRETED -> {
        if (!nextLine.test(thread)) {
          thread.state = ScriptThread.State.WAITING;
          thread.polledFrame = frame;
          thread.budget = 0;
        }
      }
      case ENDED -> {
        boolean finished = thread == run.main();
        run.end(thread);
        if (finished) {
          return FrameResult.FINISHED;
        }
      }
      case HALTED -> {
        return FrameResult.HALTED;
      }
      case PAUSED -> {
        run.pauseIsUnderWay();
        return FrameResult.PAUSED;
      }
      case TRAPPED -> {
        return FrameResult.HELD;
      }
      case JOINING -> {}
      default -> throw new IllegalStateException("a turn ended for no reason");
    }
    return FrameResult.RUNNING;
  }

  /** Runs {@code thread} on, over the traps that nobody wants to stop at. */
  private Processor.Stop execute(ScriptThread thread) throws ThreadFailure {
    running = thread;
    executing = true;
    try {
      Processor.Stop stop = processor.execute(thread);
      while (stop == Processor.Stop.TRAPPED && !sentry.stopsAt(thread.id())) {
        stop = processor.execute(thread);
      }
      return stop;
    } catch (ScriptError e) {
      throw new ThreadFailure(thread, e);
    } finally {
      executing = false;
    }
  }

  /** Whether {@code thread} can run now; looks at what it waits for, once a frame. */
  private boolean ready(ScriptThread thread) throws ThreadFailure {
    return switch (thread.state) {
      case RUNNABLE -> thread.budget > 0;
      case JOINING -> run.thread(thread.joinedThread).isEmpty() && released(thread);
      case WAITING -> thread.polledFrame != frame && waitOver(thread);
      case ENDED -> false;
    };
  }

  private static boolean released(ScriptThread thread) {
    thread.state = ScriptThread.State.RUNNABLE;
    return thread.budget > 0;
  }

  private boolean waitOver(ScriptThread thread) throws ThreadFailure {
    thread.polledFrame = frame;
    Optional<Value> result;
    try {
      result = thread.wait.poll(frame);
    } catch (ScriptError e) {
      throw new ThreadFailure(thread, e);
    }
    if (result.isEmpty()) {
      thread.budget = 0;
      return false;
    }
    run.registers().set(thread.bases[thread.depth - 1] + thread.waitResult, result.get());
    thread.state = ScriptThread.State.RUNNABLE;
    return true;
  }
}
