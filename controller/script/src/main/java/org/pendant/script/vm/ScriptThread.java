package org.pendant.script.vm;

import java.util.Arrays;
import java.util.Optional;
import org.pendant.script.function.Wait;
import org.pendant.script.value.LongOperation;
import org.pendant.script.value.Registers;
import org.pendant.script.value.Value;

/**
 * Script thread: call frames over a segment of the program's registers, and what it waits for. It
 * is plain data that the {@link Processor} works on.
 */
final class ScriptThread {
  /** Deepest nesting of calls; one more is a runtime error. */
  static final int MAX_DEPTH = 1000;

  /** What a thread can do in this frame. */
  enum State {
    RUNNABLE,
    /** Waits for something outside the script. */
    WAITING,
    /** Waits for another thread. */
    JOINING,
    ENDED
  }

  private final int id;
  private final int parentId;

  State state = State.RUNNABLE;
  Wait wait;

  /** Local index of the slot for the result of the wait. */
  int waitResult;

  /** The frame in which the wait was last looked at. */
  long polledFrame;

  /** The thread whose end this one waits for. */
  Optional<ScriptThread> joined = Optional.empty();

  /** Frames in a row that it began without having waited in the one before. */
  int busyFrames;

  boolean critical;

  /** Stopped at a trap: the instruction pointer stands before the statement that comes next. */
  boolean trapped;

  /**
   * Stopped before an instruction that is not a place to stop otherwise: only the instruction loop
   * continues from there.
   */
  boolean interrupted;

  /** Stopped by the end of its slice: the instruction pointer stands before what comes next. */
  boolean sliced;

  /** What the instruction that the thread stopped before has begun. */
  Optional<LongOperation> operation = Optional.empty();

  /** Computing time left in this frame, in nanoseconds; see {@link Cost}. */
  int budget;

  /** Computing time that was used beyond the slices so far; nothing runs until it is paid. */
  int debtNs;

  /** The last frame in which this thread was given a slice. */
  long slicedFrame;

  /** Calls in the frame of the newest slice that asked for the robot's state. */
  int questions;

  /** It waited when this frame began, or did not exist. */
  boolean waking = true;

  /** It could have run in the last frame, but others had used too much. */
  boolean deferred;

  // Call frames: function, instruction pointer, first slot, and where the caller wants the result.
  ScriptFunction[] functions = new ScriptFunction[8];
  int[] pcs = new int[8];
  int[] bases = new int[8];
  int[] results = new int[8];
  int depth;

  /** Frames of direct code that are about to become call frames. */
  final LeftFrames left = new LeftFrames();

  // The registers, while direct code runs.
  double[] numbers;
  byte[] tags;
  Value[] objects;

  /** The tag of what direct code has just returned, where it may have several. */
  int resultTag;

  int segmentStart;
  int segmentEnd;

  /**
   * How many slots from the start of its segment on belong to interpreted lines or come before
   * theirs; 0 when no lines have variables.
   */
  int lineSlots;

  /** Where coverage is marked. */
  final byte[] marks;

  ScriptThread(int id, int parentId, byte[] marks) {
    this.id = id;
    this.parentId = parentId;
    this.marks = marks;
  }

  int id() {
    return id;
  }

  int parentId() {
    return parentId;
  }

  boolean ended() {
    return state == State.ENDED;
  }

  /** Direct code is about to run. */
  void lend(Registers registers) {
    numbers = registers.numbers();
    tags = registers.tags();
    objects = registers.objects();
  }

  /** The first slot of the innermost frame. */
  int base() {
    return bases[depth - 1];
  }

  /** Enters {@code function} with its slots from {@code base}. */
  void push(ScriptFunction function, int base, int result) {
    if (depth == functions.length) {
      growFrames();
    }
    functions[depth] = function;
    pcs[depth] = 0;
    bases[depth] = base;
    results[depth] = result;
    depth++;
  }

  private void growFrames() {
    int larger = depth * 2;
    functions = Arrays.copyOf(functions, larger);
    pcs = Arrays.copyOf(pcs, larger);
    bases = Arrays.copyOf(bases, larger);
    results = Arrays.copyOf(results, larger);
  }

  /** Moves every frame after the segment was moved by {@code distance}. */
  void shift(int distance) {
    for (int i = 0; i < depth; i++) {
      bases[i] += distance;
    }
    segmentStart += distance;
  }

  /** Ends what this thread waits for early, where that is possible. */
  boolean abortWait() {
    return state == State.WAITING && wait.abort();
  }

  /** Whether the instruction pointer stands before what comes next, and not after what was. */
  boolean before() {
    return trapped || interrupted;
  }

  /** Whether it would only return from all that it has entered, and end. */
  boolean nothingLeft() {
    if (state != State.RUNNABLE || before()) {
      return false;
    }
    for (int i = 0; i < depth; i++) {
      if (!functions[i].returnsFrom(pcs[i])) {
        return false;
      }
    }
    return true;
  }

  /** The instruction that the function of call frame {@code index} has reached. */
  int reached(int index) {
    boolean ahead = (before() || sliced) && index == depth - 1;
    return ahead ? pcs[index] : Math.max(0, pcs[index] - 1);
  }

  /** The line the innermost function has reached. */
  int line() {
    return depth == 0 ? 0 : functions[depth - 1].line(reached(depth - 1));
  }
}
