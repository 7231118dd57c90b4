package org.pendant.script.vm;

/**
 * Instruction layout in a {@code long}: ten bits of operation, then three operands of 18 bits. An
 * operand that names a value is either a static slot (its index) or a local one (its index with the
 * top bit set), so that the address is found without a branch.
 */
final class Instruction {
  /** Largest index of a slot, argument list, function or member name. */
  static final int MAX_OPERAND = 0x1FFFF;

  private static final int LOCAL = 0x20000;
  private static final int OPERAND_MASK = 0x3FFFF;
  private static final long OFFSET_MASK = 0xFFFFFFFFFL;

  private Instruction() {}

  static long of(int operation, int a, int b, int c) {
    return operation
        | (long) (a & OPERAND_MASK) << 10
        | (long) (b & OPERAND_MASK) << 28
        | (long) (c & OPERAND_MASK) << 46;
  }

  /** A jump: operand {@code a} and a distance of 36 bits in place of the other two. */
  static long jump(int operation, int a, int distance) {
    return operation | (long) (a & OPERAND_MASK) << 10 | (distance & OFFSET_MASK) << 28;
  }

  /** The operand that names local slot {@code index} of the running function. */
  static int local(int index) {
    return index | LOCAL;
  }

  static boolean isLocal(int operand) {
    return (operand & LOCAL) != 0;
  }

  /** The slot's index, without the mark of a local one. */
  static int index(int operand) {
    return operand & MAX_OPERAND;
  }

  static int operation(long word) {
    return (int) word & 0x3FF;
  }

  /** Operand a, signed. */
  static int a(long word) {
    return (int) (word << 36 >> 46);
  }

  static int b(long word) {
    return (int) (word << 18 >> 46);
  }

  static int c(long word) {
    return (int) (word >> 46);
  }

  /** The distance of a jump. */
  static int distance(long word) {
    return (int) (word >> 28);
  }

  /** The place of operand {@code operand} in the register file. */
  static int slot(int operand, int base) {
    return (operand & MAX_OPERAND) + (base & (operand >> 31));
  }
}
