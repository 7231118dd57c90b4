package org.pendant.script.vm;

import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.function.Work;
import org.pendant.script.value.LongOperation;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Processor.Stop;

/**
 * Slow path: executes single instructions in full generality: the rare operations, and the rare
 * cases of the common ones, for operands that are not plain numbers.
 */
final class SlowPath {
  /** What {@link #equal} answers when the thread has stopped before the comparison. */
  static final int STOPPED = -1;

  private final ProgramRun run;
  private final Registers registers;
  private final GeneralOperations general;
  private final Call<?> call;
  private final Work work;
  private final ProgramMemory memory;

  SlowPath(ProgramRun run, GeneralOperations general, Call<?> call) {
    this.run = run;
    this.registers = run.registers();
    this.general = general;
    this.call = call;
    work = run.work();
    memory = run.memory();
  }

  /**
   * Executes the instruction before {@code pc} of the innermost function of {@code thread}. Not for
   * jumps, calls of functions and returns, except to refuse their operands or to find their truth.
   *
   * @param base the function's first slot
   * @return {@link Stop#GOES_ON}; {@link Stop#EXHAUSTED} when the thread has stopped before the
   *     instruction, since its slice is used up or the instruction takes longer than a slice; or
   *     why it stops after the instruction
   */
  Stop run(ScriptThread thread, int base, int pc) throws ScriptError {
    int top = thread.depth - 1;
    ScriptFunction function = thread.functions[top];
    long w = function.instructions()[pc - 1];
    if (thread.budget < 0 && takesTime(function, w, base)) {
      return interrupt(thread, pc);
    }
    thread.pcs[top] = pc;
    int a = Instruction.a(w);
    int operation = Instruction.operation(w);
    Stop stop = Stop.GOES_ON;
    switch (operation) {
      case Op.MOVE -> move(function, w, base, false);
      case Op.COPY -> move(function, w, base, true);
      case Op.ASSIGN, Op.ASSIGN_COPY -> {
        int source = Instruction.slot(Instruction.b(w), base);
        int slot = Instruction.slot(a, base);
        general.assign(function, a, slot, Instruction.b(w), source, operation == Op.ASSIGN_COPY);
      }
      case Op.UNSET -> registers.tags()[Instruction.slot(a, base)] = Registers.UNASSIGNED;
      case Op.ADD -> stop = general.add(thread, w, base);
      case Op.SUBTRACT -> stop = general.arithmetic(BinaryOperator.SUBTRACT, thread, w, base);
      case Op.MULTIPLY -> stop = general.arithmetic(BinaryOperator.MULTIPLY, thread, w, base);
      case Op.DIVIDE -> stop = general.arithmetic(BinaryOperator.DIVIDE, thread, w, base);
      case Op.MODULO -> stop = general.arithmetic(BinaryOperator.MODULO, thread, w, base);
      case Op.NEGATE -> stop = general.negate(thread, w, base);
      case Op.XOR -> xor(function, w, base);
      case Op.NOT -> general.truth(function, Instruction.slot(Instruction.b(w), base));
      case Op.JUMP_IF_FALSE, Op.JUMP_IF_TRUE -> general.truth(function, Instruction.slot(a, base));
      case Op.LESS, Op.LESS_OR_EQUAL ->
          throw general.notOrdered(
              function,
              Instruction.slot(Instruction.b(w), base),
              Instruction.slot(Instruction.c(w), base));
      case Op.JUMP_IF_LESS,
          Op.JUMP_IF_LESS_OR_EQUAL,
          Op.JUMP_IF_NOT_LESS,
          Op.JUMP_IF_NOT_LESS_OR_EQUAL,
          Op.LOOP_IF_LESS,
          Op.LOOP_IF_LESS_OR_EQUAL ->
          throw general.notOrdered(
              function, Instruction.slot(a, base), Instruction.slot(Instruction.b(w), base));
      case Op.RETURN -> throw general.unassigned(function, a);
      case Op.CALL_BUILTIN ->
          stop =
              callBuiltin(
                  thread,
                  run.builtin(Instruction.b(w)),
                  base + Instruction.index(Instruction.c(w)),
                  a);
      case Op.CALL_METHOD, Op.CALL_PART_METHOD -> {
        int first = base + Instruction.index(Instruction.c(w));
        stop = callBuiltin(thread, general.method(Instruction.b(w), first), first, a);
      }
      case Op.GET_INDEX -> general.getIndex(function, w, base);
      case Op.SET_INDEX -> general.setIndex(function, w, base);
      case Op.GET_INDEX_2 -> general.getIndex2(function, w, base);
      case Op.SET_INDEX_2 -> general.setIndex2(function, w, base);
      case Op.OPEN_INDEX -> general.openIndex(function, w, base);
      case Op.OPEN_MEMBER -> general.openMember(function, w, base);
      case Op.GET_MEMBER -> general.getMember(function, w, base);
      case Op.SET_MEMBER -> general.setMember(function, w, base);
      case Op.LIST -> stop = general.list(thread, w, base);
      case Op.POSE -> general.pose(w, base);
      case Op.STRUCT -> general.struct(w, base);
      case Op.RUN -> {
        work.charge(Cost.THREAD_NS);
        run.startThread(thread.id(), Instruction.b(w));
        registers.setInt(Instruction.slot(a, base), run.newestThread());
      }
      case Op.JOIN -> {
        work.charge(Cost.HANDLE_NS);
        if (run.join(thread, general.handle("join", Instruction.slot(a, base)))) {
          stop = Stop.JOINING;
        }
      }
      case Op.KILL -> {
        work.charge(Cost.HANDLE_NS);
        run.kill(general.handle("kill", Instruction.slot(a, base)));
        stop = thread.ended() ? Stop.ENDED : Stop.GOES_ON;
      }
      case Op.MISSING ->
          throw new ScriptError("missing-argument", run.name(Instruction.index(Instruction.b(w))));
      case Op.ENTER_CRITICAL -> thread.critical = true;
      case Op.EXIT_CRITICAL -> thread.critical = false;
      case Op.HALT -> stop = Stop.HALTED;
      case Op.PAUSE -> stop = Stop.PAUSED;
      case Op.INTERPRETED -> {
        thread.depth--;
        stop = Stop.INTERPRETED;
      }
      default -> throw new IllegalStateException("operation " + operation);
    }
    settleDue(thread);
    return stop == Stop.EXHAUSTED ? interrupt(thread, pc) : stop;
  }

  /**
   * {@link #run} of an addition: of strings, which programs build piece by piece, on a short way.
   */
  Stop add(ScriptThread thread, int base, int pc) throws ScriptError {
    int top = thread.depth - 1;
    thread.pcs[top] = pc;
    if (thread.budget < 0 || !general.join(thread.functions[top].instructions()[pc - 1], base)) {
      return run(thread, base, pc);
    }
    settleDue(thread);
    return Stop.GOES_ON;
  }

  /** {@link #run} of a call of a built-in function, on a short way. */
  Stop callBuiltin(ScriptThread thread, int base, int pc) throws ScriptError {
    if (thread.budget < 0) {
      return interrupt(thread, pc);
    }
    int top = thread.depth - 1;
    thread.pcs[top] = pc;
    long w = thread.functions[top].instructions()[pc - 1];
    Stop stop =
        callBuiltin(
            thread,
            run.builtin(Instruction.b(w)),
            base + Instruction.index(Instruction.c(w)),
            Instruction.a(w));
    settleDue(thread);
    return stop == Stop.EXHAUSTED ? interrupt(thread, pc) : stop;
  }

  /**
   * Whether an instruction may take so long that it has to wait for a slice. Not if its operands
   * are plain numbers, where it may never come here, and not in the middle of a change of a part,
   * which nobody must come in between of.
   */
  private boolean takesTime(ScriptFunction function, long w, int base) {
    return switch (Instruction.operation(w)) {
      case Op.COPY, Op.ASSIGN, Op.ASSIGN_COPY, Op.NEGATE -> isObject(Instruction.b(w), base);
      case Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE, Op.MODULO ->
          isObject(Instruction.b(w), base) || isObject(Instruction.c(w), base);
      case Op.GET_INDEX ->
          isObject(Instruction.b(w), base)
              && registers.objects()[Instruction.slot(Instruction.b(w), base)]
                  instanceof MatrixValue;
      case Op.OPEN_INDEX, Op.OPEN_MEMBER -> copied(function, Instruction.b(w), base);
      case Op.SET_INDEX, Op.SET_INDEX_2, Op.SET_MEMBER -> copied(function, Instruction.a(w), base);
      case Op.CALL_BUILTIN, Op.CALL_METHOD, Op.LIST, Op.STRUCT, Op.RUN, Op.JOIN, Op.KILL -> true;
      default -> false;
    };
  }

  /** Whether a variable is about to be changed whose parts have to be copied before. */
  private boolean copied(ScriptFunction function, int operand, int base) {
    boolean variable =
        !Instruction.isLocal(operand) || Instruction.index(operand) < function.variableCount();
    return variable
        && isObject(operand, base)
        && Cost.change(registers.objects()[Instruction.slot(operand, base)]) > 0;
  }

  private boolean isObject(int operand, int base) {
    return registers.tags()[Instruction.slot(operand, base)] == Registers.OBJECT;
  }

  /** Stops {@code thread} before the instruction before {@code pc}. */
  private static Stop interrupt(ScriptThread thread, int pc) {
    thread.interrupted = true;
    return Processor.stop(thread, pc - 1, Stop.EXHAUSTED);
  }

  private void settleDue(ScriptThread thread) throws ScriptError {
    if (work.due()) {
      settle(thread);
    }
  }

  /** Takes what has been done off the thread's slice and counts the values that are new. */
  void settle(ScriptThread thread) throws ScriptError {
    if (work.tookBytes()) {
      work.charge(memory.took(work.settleBytes(), run));
    }
    thread.budget -= work.settleNs();
  }

  private void move(ScriptFunction function, long w, int base, boolean copy) throws ScriptError {
    int source = Instruction.slot(Instruction.b(w), base);
    int slot = Instruction.slot(Instruction.a(w), base);
    if (!registers.assigned(source)) {
      throw general.unassigned(function, Instruction.b(w));
    }
    registers.tags()[slot] = registers.tags()[source];
    registers.numbers()[slot] = registers.numbers()[source];
    if (registers.tags()[source] == Registers.OBJECT) {
      Value object = registers.objects()[source];
      registers.objects()[slot] = copy ? general.copied(object) : object;
    }
  }

  private void xor(ScriptFunction function, long w, int base) throws ScriptError {
    int x = Instruction.slot(Instruction.b(w), base);
    int y = Instruction.slot(Instruction.c(w), base);
    general.truth(function, x);
    general.truth(function, y);
    registers.setBool(
        Instruction.slot(Instruction.a(w), base),
        registers.numbers()[x] != 0 != (registers.numbers()[y] != 0));
  }

  private Stop callBuiltin(ScriptThread thread, Builtin<?> builtin, int first, int result)
      throws ScriptError {
    int slot = Instruction.index(result);
    int target = thread.bases[thread.depth - 1] + slot;
    work.charge(Cost.BUILTIN_NS);
    if (builtin.repeatsItself()) {
      work.charge(Cost.question(thread.questions++));
    }
    Outcome outcome =
        thread.operation.isPresent()
            ? new Outcome.Begun(thread.operation.get())
            : call.run(builtin, first, target);
    // almost all: it takes longer to find that this is neither of the others
    if (outcome != Outcome.Answered.ANSWERED) {
      if (outcome instanceof Outcome.Begun begun) {
        LongOperation operation = begun.operation();
        if (!general.finish(thread, operation)) {
          return Stop.EXHAUSTED;
        }
        outcome = call.resume(builtin, first, target, operation.result());
      }
      if (outcome instanceof Wait wait) {
        thread.wait = wait;
        thread.waitResult = slot;
        return Stop.WAITING;
      }
    }
    if (run.haltRequested()) {
      return Stop.HALTED;
    }
    return run.pauseRequested() ? Stop.PAUSED : Stop.GOES_ON;
  }

  /**
   * Whether the operands that the instruction before {@code pc} compares are equal: 1 or 0, or
   * {@link #STOPPED} as {@link Stop#EXHAUSTED} of {@link #run}.
   */
  int equal(ScriptThread thread, int base, int pc) throws ScriptError {
    long w = thread.functions[thread.depth - 1].instructions()[pc - 1];
    boolean jumps = Instruction.operation(w) >= Op.JUMP_IF_EQUAL;
    int x = jumps ? Instruction.a(w) : Instruction.b(w);
    int y = jumps ? Instruction.b(w) : Instruction.c(w);
    if (thread.budget < 0 && isObject(x, base) && isObject(y, base)) {
      interrupt(thread, pc);
      return STOPPED;
    }
    thread.pcs[thread.depth - 1] = pc;
    int equal = general.equal(thread, Instruction.slot(x, base), Instruction.slot(y, base));
    settleDue(thread);
    if (equal == STOPPED) {
      interrupt(thread, pc);
    }
    return equal;
  }
}
