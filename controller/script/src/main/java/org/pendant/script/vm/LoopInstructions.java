package org.pendant.script.vm;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.SortedSet;
import java.util.TreeSet;

/** Loop instructions: what instructions in loops are to code that runs loops directly. */
final class LoopInstructions {
  /** Longer loops never run directly, but shorter ones within them do. */
  private static final int MAX_INSTRUCTIONS = 150;

  private LoopInstructions() {}

  /** What instruction {@code pc} jumps back to at the end of a loop; -1 for any other. */
  static int backTo(long w, int pc) {
    return switch (Instruction.operation(w)) {
      case Op.LOOP, Op.LOOP_IF_LESS, Op.LOOP_IF_LESS_OR_EQUAL -> Jumps.target(w, pc);
      default -> -1;
    };
  }

  /** The operands for values of what a loop does itself, in which arguments do not count. */
  static int[] operands(long w) {
    int a = Instruction.a(w);
    int b = Instruction.b(w);
    int c = Instruction.c(w);
    return switch (Instruction.operation(w)) {
      case Op.MOVE,
          Op.COPY,
          Op.ASSIGN,
          Op.ASSIGN_COPY,
          Op.NEGATE,
          Op.NOT,
          Op.GET_INDEX_2,
          Op.JUMP_IF_LESS,
          Op.JUMP_IF_LESS_OR_EQUAL,
          Op.JUMP_IF_NOT_LESS,
          Op.JUMP_IF_NOT_LESS_OR_EQUAL,
          Op.JUMP_IF_EQUAL,
          Op.JUMP_IF_NOT_EQUAL,
          Op.LOOP_IF_LESS,
          Op.LOOP_IF_LESS_OR_EQUAL ->
          new int[] {a, b};
      case Op.ADD,
          Op.SUBTRACT,
          Op.MULTIPLY,
          Op.DIVIDE,
          Op.MODULO,
          Op.EQUAL,
          Op.NOT_EQUAL,
          Op.LESS,
          Op.LESS_OR_EQUAL,
          Op.GET_INDEX,
          Op.SET_INDEX ->
          new int[] {a, b, c};
      case Op.SET_INDEX_2 -> new int[] {a, c};
      case Op.UNSET, Op.JUMP_IF_GIVEN, Op.JUMP_IF_FALSE, Op.JUMP_IF_TRUE, Op.CALL -> new int[] {a};
      default -> new int[0];
    };
  }

  /** As {@link #operands}, of a function, which may return. */
  static int[] operandsInFunction(long w) {
    return Instruction.operation(w) == Op.RETURN ? new int[] {Instruction.a(w)} : operands(w);
  }

  /** The number of the function that {@code w} calls, if it calls one. */
  static Optional<Integer> called(long w, Program.Tables tables) {
    return Instruction.operation(w) == Op.CALL && Instruction.b(w) < tables.functions().size()
        ? Optional.of(Instruction.b(w))
        : Optional.empty();
  }

  /** The operand that a loop itself writes a number or bool to. */
  static OptionalInt target(long w) {
    return switch (Instruction.operation(w)) {
      case Op.MOVE,
          Op.COPY,
          Op.ASSIGN,
          Op.ASSIGN_COPY,
          Op.UNSET,
          Op.ADD,
          Op.SUBTRACT,
          Op.MULTIPLY,
          Op.DIVIDE,
          Op.MODULO,
          Op.NEGATE,
          Op.NOT,
          Op.EQUAL,
          Op.NOT_EQUAL,
          Op.LESS,
          Op.LESS_OR_EQUAL,
          Op.GET_INDEX,
          Op.GET_INDEX_2,
          Op.CALL ->
          OptionalInt.of(Instruction.a(w));
      default -> OptionalInt.empty();
    };
  }

  /** Whether a loop that runs directly ends before {@code w}, whatever its operands are. */
  static boolean endsBefore(long w) {
    return switch (Instruction.operation(w)) {
      case Op.JUMP, Op.LOOP, Op.STRETCH, Op.SET_INDEX, Op.SET_INDEX_2, Op.MARK -> false;
      default -> operands(w).length == 0;
    };
  }

  /** Where code continues with what loops have left: behind them, and where they end within. */
  static SortedSet<Integer> waysOut(long[] instructions) {
    SortedSet<Integer> ways = new TreeSet<>();
    int end = -1;
    for (int pc = 0; pc < instructions.length; pc++) {
      if (pc > end) {
        end = endOfLoop(instructions, pc);
      }
      if (pc > end) {
        continue;
      }
      if (endsBefore(instructions[pc])) {
        ways.add(pc);
      }
      int target = Jumps.target(instructions[pc], pc);
      if (target > end) {
        ways.add(target);
      }
      if (pc == end) {
        ways.add(pc + 1);
      }
    }
    return ways.headSet(instructions.length);
  }

  /** Where the outermost loop begins that runs directly and a turn at {@code head} belongs to. */
  static int outermost(long[] instructions, int head) {
    int outermost = head;
    for (int pc = head; pc < Math.min(instructions.length, head + MAX_INSTRUCTIONS); pc++) {
      int first = backTo(instructions[pc], pc);
      if (first >= 0 && pc - first < MAX_INSTRUCTIONS) {
        outermost = Math.min(outermost, first);
      }
    }
    return outermost;
  }

  /**
   * The last instruction of the loop that begins with instruction {@code first}; -1 for none that
   * runs directly.
   */
  static int endOfLoop(long[] instructions, int first) {
    int end = -1;
    for (int pc = first; pc < Math.min(instructions.length, first + MAX_INSTRUCTIONS); pc++) {
      if (backTo(instructions[pc], pc) == first) {
        end = pc;
      }
    }
    return end;
  }
}
