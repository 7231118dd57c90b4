package org.pendant.script.vm;

/** Jumps: where the run of a function goes on from an instruction. */
final class Jumps {
  private Jumps() {}

  /** What instruction {@code pc} may jump to; -1 for one that never jumps. */
  static int target(long w, int pc) {
    return switch (Instruction.operation(w)) {
      case Op.JUMP, Op.LOOP, Op.JUMP_IF_GIVEN, Op.JUMP_IF_FALSE, Op.JUMP_IF_TRUE ->
          pc + 1 + Instruction.distance(w);
      case Op.JUMP_IF_LESS,
          Op.JUMP_IF_LESS_OR_EQUAL,
          Op.JUMP_IF_NOT_LESS,
          Op.JUMP_IF_NOT_LESS_OR_EQUAL,
          Op.JUMP_IF_EQUAL,
          Op.JUMP_IF_NOT_EQUAL,
          Op.LOOP_IF_LESS,
          Op.LOOP_IF_LESS_OR_EQUAL ->
          pc + 1 + Instruction.c(w);
      default -> -1;
    };
  }

  /** Whether the run may go on with the instruction behind {@code w}. */
  static boolean fallsThrough(long w) {
    return switch (Instruction.operation(w)) {
      case Op.JUMP, Op.LOOP, Op.RETURN, Op.RETURN_NONE, Op.INTERPRETED, Op.MISSING -> false;
      default -> true;
    };
  }
}
