package org.pendant.script.vm;

import org.pendant.script.function.Call;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;

/**
 * Processor: executes instructions of one thread until it stops for a reason: translated functions
 * by their own {@link TranslatedCode}, all others in the {@link InstructionLoop}.
 */
final class Processor {
  /** Why code returned to the code that ran it; the first four never leave {@link #execute}. */
  enum Stop {
    /** Nothing has stopped; only single instructions answer this. */
    GOES_ON,
    /** A frame was left, its caller's is the innermost one now. */
    RETURNED,
    /** A turn begins of an interpreted function, whose loop may have code of its own. */
    TURNED,
    /** A frame was pushed that has to be run next. */
    CALLED,
    /** A wait began; it stands in the thread. */
    WAITING,
    JOINING,
    /** The budget of this frame is used up. */
    EXHAUSTED,
    ENDED,
    HALTED,
    PAUSED,
    /** An interpreted statement was executed to its end. */
    INTERPRETED,
    /** A statement is about to begin that a trap stands before. */
    TRAPPED
  }

  /**
   * Translated functions call each other without coming back here, except at depths that are a
   * multiple of this: it bounds the use of the Java stack.
   */
  private static final int NESTING = 128;

  /** So many times as long it is not looked for code of a loop when there was none. */
  private static final int TURNS_WITHOUT_LOOP = 16;

  /** The tag bits that keep a number from being stored into a variable as it is. */
  static final int NOT_FOR_NUMBER = Registers.BOOL | Registers.NONE | Registers.OBJECT;

  /** Answered after a direct call: there is nothing left to be run. */
  private static final TranslatedCode DONE =
      new TranslatedCode() {
        @Override
        Stop run(Processor processor, ScriptThread thread, int base, int pc) {
          return Stop.RETURNED;
        }
      };

  private final ProgramRun run;
  private final Registers registers;
  private final GeneralOperations general;
  private final SlowPath slow;
  private final HotFunctions hot;
  private final InstructionLoop loop;
  private Stop refusal = Stop.CALLED;
  private int turnsUntilLoop;

  Processor(ProgramRun run, Call<?> call, HotFunctions hot) {
    this.run = run;
    this.registers = run.registers();
    this.general = new GeneralOperations(run);
    this.slow = new SlowPath(run, general, call);
    this.hot = hot;
    this.loop = new InstructionLoop(run, general, slow, hot);
    turnsUntilLoop = hot.turnsUntilLoop();
  }

  /**
   * Runs {@code thread} on from where it is.
   *
   * @throws ScriptError for a runtime error; the thread's instruction pointers tell where
   */
  Stop execute(ScriptThread thread) throws ScriptError {
    while (true) {
      int top = thread.depth - 1;
      TranslatedCode code = thread.interrupted ? null : hot.code(thread.functions[top]);
      Stop stop =
          code != null
              ? code.run(this, thread, thread.bases[top], thread.pcs[top])
              : loop.run(thread);
      if (stop == Stop.TURNED) {
        stop = turn(thread);
      }
      if (stop.compareTo(Stop.CALLED) > 0) {
        slow.settle(thread);
        return stop;
      }
    }
  }

  /** Goes on directly, if possible, with the loop of a function that has no translation. */
  private Stop turn(ScriptThread thread) {
    int top = thread.depth - 1;
    int next = loop(thread, thread.bases[top], thread.pcs[top]);
    if (next < 0) {
      return refusal;
    }
    thread.pcs[top] = next;
    return Stop.CALLED;
  }

  // --- what translated code needs

  Registers registers() {
    return registers;
  }

  /** Where coverage is marked. */
  byte[] marks() {
    return run.marks();
  }

  SlowPath slow() {
    return slow;
  }

  /**
   * Counts a call and pushes its frame, or makes the call as a whole.
   *
   * @param pc after the call
   * @param offset of the callee's first slot from {@code base}
   * @return the callee's code, to be run at once; null when the caller has to return {@link
   *     #refusal}
   */
  TranslatedCode enter(ScriptThread thread, int base, int pc, int number, int offset, int result)
      throws ScriptError {
    int depth = thread.depth;
    thread.pcs[depth - 1] = pc;
    if (thread.budget < 0) {
      refusal = stop(thread, pc - 1, Stop.EXHAUSTED);
      return null;
    }
    ScriptFunction callee = run.functions()[number];
    int first = base + offset;
    if (callee.mayBeDirect()) {
      DirectEntry direct = direct(thread, callee, number, first);
      if (direct != null) {
        return callDirectly(thread, direct, first, result);
      }
    }
    thread.budget -= callee.callNs();
    if (depth >= ScriptThread.MAX_DEPTH || first + callee.slotCount() > thread.segmentEnd) {
      general.makeRoom(thread, callee, first);
      first = thread.base() + offset;
    }
    byte[] tag = registers.tags();
    for (int i = first + callee.parameterCount(), end = first + callee.variableCount();
        i < end;
        i++) {
      tag[i] = Registers.UNASSIGNED;
    }
    thread.push(callee, first, result);
    TranslatedCode code = callee.translated();
    if (code == null || (depth & (NESTING - 1)) == 0) {
      refusal = Stop.CALLED;
      return null;
    }
    return code;
  }

  /** What a function is called directly with; null when it must or can not be. */
  private DirectEntry direct(ScriptThread thread, ScriptFunction callee, int number, int first) {
    int count = callee.parameterCount();
    if (callee.translated() == null
        || run.trapped()
        || count > DirectEntry.MAX_PARAMETERS
        || room(thread) < 0) {
      return null;
    }
    byte[] tags = registers.tags();
    long key = 0;
    for (int i = 0; i < count; i++) {
      int tag = tags[first + i];
      if (tag == Registers.OBJECT) {
        callee.wasNotDirect(1);
        return null;
      }
      key = DirectEntry.key(key, i, tag);
    }
    DirectEntry entry = hot.direct(callee, number, key, registers);
    if (entry == null || entry.depth(thread.segmentEnd - first) < 0) {
      return null;
    }
    if (!entry.worthwhile()) {
      callee.wasNotDirect(1);
      return null;
    }
    return entry;
  }

  /** How deep calls may be in a direct call of a function that is not yet entered. */
  private static int room(ScriptThread thread) {
    int depth = thread.depth;
    return (depth & (NESTING - 1)) == 0
        ? -1
        : Math.min(NESTING - 1 - (depth & (NESTING - 1)), ScriptThread.MAX_DEPTH - 1 - depth);
  }

  /** Answers as {@link #enter}. */
  private TranslatedCode callDirectly(
      ScriptThread thread, DirectEntry direct, int first, int result) {
    thread.lend(registers);
    int target = thread.base() + result;
    int room = Math.min(room(thread), direct.depth(thread.segmentEnd - first));
    if (direct.code().call(thread, room, registers.numbers(), registers.tags(), first, target)) {
      return DONE;
    }
    int how = thread.left.push(thread, run.functions(), registers, first, result);
    refusal = how == LeftFrames.IN_NEXT_SLICE ? Stop.EXHAUSTED : Stop.CALLED;
    if (how == LeftFrames.INTERPRETED) {
      direct.exited();
      thread.interrupted = true;
    }
    return null;
  }

  /**
   * Turns of loops in translated code before {@link #loop} is to be called: many right after there
   * was no code.
   */
  int takeTurnsUntilLoop() {
    int turns = turnsUntilLoop;
    turnsUntilLoop = hot.turnsUntilLoop();
    return turns;
  }

  /**
   * Goes on directly, if possible, with the loop that begins a turn at {@code pc} of the innermost
   * frame.
   *
   * @return the instruction that the frame's code continues with; negative when the caller has to
   *     return {@link #refusal}
   */
  int loop(ScriptThread thread, int base, int pc) {
    ScriptFunction function = thread.functions[thread.depth - 1];
    LoopEntry loop = run.trapped() ? null : hot.loop(function, pc, registers, base);
    if (loop == null) {
      turnsUntilLoop = TURNS_WITHOUT_LOOP * hot.turnsUntilLoop();
      return pc;
    }
    int budget = thread.budget;
    thread.lend(registers);
    int room = Math.min(room(thread) + 1, loop.depth(thread.segmentEnd - base));
    loop.code().run(thread, room, registers.numbers(), registers.tags(), registers.objects(), base);
    loop.ran(budget - thread.budget);
    int depth = thread.depth;
    int how = thread.left.pushAboveLoop(thread, run.functions(), registers);
    if (how == LeftFrames.IN_ANY_FORM && thread.depth == depth) {
      return thread.pcs[depth - 1];
    }
    refusal = how == LeftFrames.IN_NEXT_SLICE ? Stop.EXHAUSTED : Stop.CALLED;
    thread.interrupted = how == LeftFrames.INTERPRETED;
    return -1;
  }

  /** Why {@link #enter} or {@link #loop} cannot go on. */
  Stop refusal() {
    return refusal;
  }

  /** Leaves the innermost frame with a value that is assigned; its object is in {@code source}. */
  Stop leave(ScriptThread thread, int tag, double number, int source) {
    int depth = --thread.depth;
    if (depth == 0) {
      return Stop.ENDED;
    }
    int d = thread.bases[depth - 1] + thread.results[depth];
    registers.tags()[d] = (byte) tag;
    registers.numbers()[d] = number;
    if (tag == Registers.OBJECT) {
      registers.objects()[d] = registers.objects()[source];
    }
    return Stop.RETURNED;
  }

  /** Ends a thread's turn for this frame before instruction {@code pc}. */
  static Stop exhausted(ScriptThread thread, int pc) {
    return stop(thread, pc, Stop.EXHAUSTED);
  }

  /** Stops {@code thread} before instruction {@code pc}. */
  static Stop stop(ScriptThread thread, int pc, Stop stop) {
    thread.pcs[thread.depth - 1] = pc;
    return stop;
  }
}
