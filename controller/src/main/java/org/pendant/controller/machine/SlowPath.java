package org.pendant.controller.machine;

import org.pendant.controller.call.Builtin;
import org.pendant.controller.call.Call;
import org.pendant.controller.call.Outcome;
import org.pendant.controller.call.Wait;
import org.pendant.controller.machine.Processor.Stop;
import org.pendant.controller.value.Registers;
import org.pendant.controller.value.ScriptError;
import org.pendant.controller.value.Value;
import org.pendant.language.syntax.Expression.BinaryOperator;

/**
 * Executes single instructions in full generality: the rare operations, and the rare cases of the
 * common ones, for operands that are not plain numbers.
 */
final class SlowPath {
  private final ProgramRun run;
  private final Registers registers;
  private final GeneralOperations general;
  private final Call call;

  SlowPath(ProgramRun run, GeneralOperations general, Call call) {
    this.run = run;
    this.registers = run.registers();
    this.general = general;
    this.call = call;
  }

  /**
   * Executes the instruction before {@code pc} of the innermost function of {@code thread}. Not for
   * jumps, calls of functions and returns, except to refuse their operands.
   *
   * @param base the function's first slot
   * @return {@link Stop#GOES_ON}, or why the thread stops behind the instruction
   */
  Stop run(ScriptThread thread, int base, int pc) throws ScriptError {
    thread.pcs[thread.depth - 1] = pc;
    ScriptFunction function = thread.functions[thread.depth - 1];
    long w = function.instructions()[pc - 1];
    int a = Instruction.a(w);
    int operation = Instruction.operation(w);
    switch (operation) {
      case Op.MOVE -> move(function, w, base, false);
      case Op.COPY -> move(function, w, base, true);
      case Op.ASSIGN, Op.ASSIGN_COPY -> {
        int source = Instruction.slot(Instruction.b(w), base);
        int slot = Instruction.slot(a, base);
        general.assign(function, a, slot, Instruction.b(w), source, operation == Op.ASSIGN_COPY);
      }
      case Op.UNSET -> registers.tags()[Instruction.slot(a, base)] = Registers.UNASSIGNED;
      case Op.ADD -> general.add(function, w, base);
      case Op.SUBTRACT -> general.arithmetic(BinaryOperator.SUBTRACT, function, w, base);
      case Op.MULTIPLY -> general.arithmetic(BinaryOperator.MULTIPLY, function, w, base);
      case Op.DIVIDE -> general.arithmetic(BinaryOperator.DIVIDE, function, w, base);
      case Op.MODULO -> general.arithmetic(BinaryOperator.MODULO, function, w, base);
      case Op.NEGATE -> general.negate(function, w, base);
      case Op.XOR -> xor(function, w, base);
      case Op.NOT -> throw general.notTruth(function, Instruction.slot(Instruction.b(w), base));
      case Op.JUMP_IF_FALSE, Op.JUMP_IF_TRUE ->
          throw general.notTruth(function, Instruction.slot(a, base));
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
      case Op.CALL_BUILTIN -> {
        return callBuiltin(
            thread, run.builtin(Instruction.b(w)), base + Instruction.index(Instruction.c(w)), a);
      }
      case Op.CALL_METHOD -> {
        int first = base + Instruction.index(Instruction.c(w));
        return callBuiltin(thread, general.method(Instruction.b(w), first), first, a);
      }
      case Op.GET_INDEX -> general.getIndex(function, w, base);
      case Op.SET_INDEX -> general.setIndex(function, w, base);
      case Op.GET_INDEX_2 -> general.getIndex2(function, w, base);
      case Op.SET_INDEX_2 -> general.setIndex2(function, w, base);
      case Op.GET_MEMBER -> general.getMember(function, w, base);
      case Op.SET_MEMBER -> general.setMember(function, w, base);
      case Op.LIST -> general.list(w, base);
      case Op.POSE -> general.pose(w, base);
      case Op.STRUCT -> general.struct(w, base);
      case Op.RUN -> {
        run.startThread(thread.id(), Instruction.b(w));
        registers.setInt(Instruction.slot(a, base), run.newestThread());
      }
      case Op.JOIN -> {
        if (run.join(thread, general.handle("join", Instruction.slot(a, base)))) {
          return Stop.JOINING;
        }
      }
      case Op.KILL -> {
        run.kill(general.handle("kill", Instruction.slot(a, base)));
        return thread.ended() ? Stop.ENDED : Stop.GOES_ON;
      }
      case Op.ENTER_CRITICAL -> thread.critical = true;
      case Op.EXIT_CRITICAL -> thread.critical = false;
      case Op.HALT -> {
        return Stop.HALTED;
      }
      case Op.PAUSE -> {
        return Stop.PAUSED;
      }
      case Op.INTERPRETED -> {
        thread.depth--;
        return Stop.INTERPRETED;
      }
      default -> throw new IllegalStateException("operation " + operation);
    }
    return Stop.GOES_ON;
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
      registers.objects()[slot] = copy ? object.copy() : object;
    }
  }

  private void xor(ScriptFunction function, long w, int base) throws ScriptError {
    int x = Instruction.slot(Instruction.b(w), base);
    int y = Instruction.slot(Instruction.c(w), base);
    byte[] tags = registers.tags();
    if ((tags[x] | tags[y]) > (Registers.BOOL | Registers.FLOAT)) {
      throw general.notTruth(function, tags[x] > Registers.BOOL ? x : y);
    }
    registers.setBool(
        Instruction.slot(Instruction.a(w), base),
        registers.numbers()[x] != 0 != (registers.numbers()[y] != 0));
  }

  private Stop callBuiltin(ScriptThread thread, Builtin builtin, int first, int result)
      throws ScriptError {
    int base = thread.bases[thread.depth - 1];
    int slot = Instruction.index(result);
    Outcome outcome = call.run(builtin, first, base + slot);
    if (outcome instanceof Wait wait) {
      thread.wait = wait;
      thread.waitResult = slot;
      return Stop.WAITING;
    }
    if (run.haltRequested()) {
      return Stop.HALTED;
    }
    return run.pauseRequested() ? Stop.PAUSED : Stop.GOES_ON;
  }

  /** Whether the operands that the instruction before {@code pc} compares are equal. */
  boolean equal(ScriptThread thread, int base, int pc) throws ScriptError {
    thread.pcs[thread.depth - 1] = pc;
    long w = thread.functions[thread.depth - 1].instructions()[pc - 1];
    boolean jumps = Instruction.operation(w) >= Op.JUMP_IF_EQUAL;
    return general.equal(
        Instruction.slot(jumps ? Instruction.a(w) : Instruction.b(w), base),
        Instruction.slot(jumps ? Instruction.b(w) : Instruction.c(w), base));
  }
}
