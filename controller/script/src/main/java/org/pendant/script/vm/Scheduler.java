package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Scheduler: gives each runnable thread of a program its share of a frame (manual 10.2). A debugger
 * may hold it within a frame; it continues then exactly where it was.
 */
final class Scheduler {
  /** What a thread may use beyond its slice before the threads after it wait for the next frame. */
  private static final int OVERDRAFT_NS = 200_000;

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
  private final DebugHook debugHook;
  private final Slices slices;
  private final List<ScriptThread> order = new ArrayList<>();
  private ScriptThread running;
  private boolean executing;
  private long frame;

  // where the round of the frame is
  private int next;
  private int computing;
  private int wakingLeftNs;

  /** A thread used so much that no other runs in this frame. */
  private boolean usedUp;

  private boolean progress;
  private boolean held;

  Scheduler(
      ProgramRun run,
      Processor processor,
      Predicate<ScriptThread> nextLine,
      DebugHook debugHook,
      Slices slices) {
    this.run = run;
    this.slices = slices;
    this.processor = processor;
    this.nextLine = nextLine;
    this.debugHook = debugHook;
  }

  /** A new thread, which has its turn after the others. */
  void add(ScriptThread thread) {
    order.add(thread);
  }

  /** A thread that has ended. */
  void remove(ScriptThread thread) {
    int index = order.indexOf(thread);
    order.remove(index);
    if (index < next) {
      next--;
    }
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

  /** Whether it is paused within a frame. */
  boolean held() {
    return held;
  }

  /**
   * Runs every runnable thread until it waits, ends or has used its slice. Continues with the frame
   * that it was paused in.
   */
  FrameResult advance() throws ThreadFailure {
    if (!held) {
      begin();
    }
    return rounds();
  }

  private static int compareTurns(ScriptThread a, ScriptThread b) {
    if (a.critical != b.critical) {
      return a.critical ? -1 : 1;
    }
    if (a.deferred != b.deferred) {
      return a.deferred ? -1 : 1;
    }
    int byDebt = Boolean.compare(a.debtNs > 0, b.debtNs > 0);
    return byDebt != 0 ? byDebt : Integer.compare(a.id(), b.id());
  }

  /**
   * Those that had no turn go first, those that have used too much last. What was used beyond a
   * slice is paid with the slices of the frames that follow.
   */
  private void begin() {
    frame++;
    if (order.size() > 1) {
      order.sort(Scheduler::compareTurns);
    }
    computing = 0;
    for (int i = 0; i < order.size(); i++) {
      ScriptThread thread = order.get(i);
      thread.deferred = false;
      thread.waking = thread.state != ScriptThread.State.RUNNABLE;
      thread.busyFrames = thread.waking ? 0 : thread.busyFrames + 1;
      if (!thread.waking || thread.debtNs > 0) {
        computing++;
      }
    }
    payDebts(slices.computing(computing));
    wakingLeftNs = slices.wakingNs();
    usedUp = false;
    next = 0;
    progress = false;
  }

  /** A thread that owes {@code shareNs} or more has no turn in this frame. */
  private void payDebts(int shareNs) {
    for (int i = 0; i < order.size(); i++) {
      ScriptThread thread = order.get(i);
      if (thread.debtNs >= shareNs) {
        thread.debtNs -= shareNs;
        thread.budget = 0;
        thread.slicedFrame = frame;
      }
    }
  }

  /** Goes round the threads until none can do more in this frame. */
  private FrameResult rounds() throws ThreadFailure {
    if (held) {
      held = false;
      // it may have been killed meanwhile
      FrameResult result = running.ended() ? FrameResult.RUNNING : turn(running);
      if (result != FrameResult.RUNNING || keepsOthersOut(running)) {
        return result;
      }
    }
    while (true) {
      // threads started meanwhile stand at the end and get their turn too
      while (next < order.size()) {
        ScriptThread thread = order.get(next++);
        if (ready(thread)) {
          progress = true;
          FrameResult result = turn(thread);
          if (result != FrameResult.RUNNING || keepsOthersOut(thread)) {
            return result;
          }
        }
      }
      if (!progress) {
        return FrameResult.RUNNING;
      }
      next = 0;
      progress = false;
    }
  }

  /** Out of its slice inside a critical section: no other thread runs until it continues. */
  private static boolean keepsOthersOut(ScriptThread thread) {
    return thread.critical && thread.state == ScriptThread.State.RUNNABLE;
  }

  private FrameResult turn(ScriptThread thread) throws ThreadFailure {
    int before = thread.budget;
    Processor.Stop stop = execute(thread);
    if (thread.waking) {
      wakingLeftNs -= before - thread.budget;
    }
    FrameResult result = followed(thread, stop);
    // what is paused continues as if nothing had been
    if (thread.budget < 0 && result != FrameResult.HELD) {
      usedUp |= thread.budget < -OVERDRAFT_NS;
      thread.debtNs = -thread.budget;
      thread.budget = 0;
    }
    return result;
  }

  private FrameResult followed(ScriptThread thread, Processor.Stop stop) {
    switch (stop) {
      case WAITING -> pause(thread);
      case EXHAUSTED -> {
        thread.sliced = true;
        endSlice(thread);
      }
      case INTERPRETED -> {
        if (!nextLine.test(thread)) {
          pause(thread);
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
        held = true;
        return FrameResult.HELD;
      }
      case JOINING -> {}
      default -> throw new IllegalStateException("a turn ended for no reason");
    }
    return FrameResult.RUNNING;
  }

  private void pause(ScriptThread thread) {
    thread.state = ScriptThread.State.WAITING;
    thread.polledFrame = frame;
    endSlice(thread);
  }

  /** Nothing is left for this frame. */
  private static void endSlice(ScriptThread thread) {
    thread.budget = Math.min(0, thread.budget);
  }

  /** Runs {@code thread} on, over the traps that need no stop. */
  private Processor.Stop execute(ScriptThread thread) throws ThreadFailure {
    running = thread;
    executing = true;
    thread.sliced = false;
    try {
      Processor.Stop stop = processor.execute(thread);
      while (stop == Processor.Stop.TRAPPED && !debugHook.stopsAt(thread.id())) {
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
    boolean wants =
        switch (thread.state) {
          case RUNNABLE -> true;
          case JOINING -> thread.joined.orElseThrow().ended() && released(thread);
          case WAITING -> thread.polledFrame != frame && waitOver(thread);
          case ENDED -> false;
        };
    if (!wants) {
      return false;
    }
    slice(thread);
    if (usedUp && thread.budget > 0) {
      thread.deferred = true;
      thread.budget = 0;
    }
    return thread.budget > 0;
  }

  /** Gives {@code thread} its slice when it can run for the first time in this frame. */
  private void slice(ScriptThread thread) {
    if (thread.slicedFrame == frame) {
      return;
    }
    thread.slicedFrame = frame;
    thread.questions = 0;
    int sliceNs = thread.waking ? slices.waking(wakingLeftNs) : slices.computing(computing);
    thread.deferred = sliceNs == 0;
    thread.budget = Math.max(0, sliceNs - thread.debtNs);
    thread.debtNs = Math.max(0, thread.debtNs - sliceNs);
  }

  private static boolean released(ScriptThread thread) {
    thread.state = ScriptThread.State.RUNNABLE;
    thread.waking = true;
    return true;
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
      return false;
    }
    run.registers().set(thread.bases[thread.depth - 1] + thread.waitResult, result.get());
    run.work().take(result.get().sizeBytes());
    return released(thread);
  }
}
