package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.Arrays;
import java.util.BitSet;
import org.pendant.language.source.SourceRange;

/** Code builder: collects the instructions of one function, with the source range of each. */
final class CodeBuilder {
  private long[] code = new long[32];
  private int[] starts = new int[32];
  private int[] ends = new int[32];
  private final StatementTable statements = new StatementTable();
  private int size;

  /** The instructions that are there for coverage alone, and cost nothing. */
  private final BitSet unpaid = new BitSet();

  /** Where the instructions begin that no {@link Op#STRETCH} counts yet. */
  private int stretch;

  private SourceRange range = new SourceRange(0, 0);

  /** The range that the following instructions are compiled from. */
  void at(SourceRange range) {
    this.range = range;
  }

  /** A statement begins here; {@code head} is it without its blocks. */
  void beginStatement(SourceRange head) {
    if (paid(stretch) >= Cost.MAX_STRETCH) {
      emit(Op.STRETCH, 0, 0, 0);
      stretch = size;
    }
    statements.add(unpaid.previousClearBit(size - 1) + 1, size, head);
  }

  /** How many instructions from {@code first} on are not free. */
  int paid(int first) {
    return size - first - unpaid(first);
  }

  private int unpaid(int first) {
    return unpaid.isEmpty() ? 0 : unpaid.get(first, size).cardinality();
  }

  StatementTable statements() {
    return statements;
  }

  SourceRange range() {
    return range;
  }

  int size() {
    return size;
  }

  int emit(int operation, int a, int b, int c) {
    return add(Instruction.of(operation, a, b, c));
  }

  /** A jump whose distance {@link #land} fills in. */
  int emitJump(int operation, int a) {
    return add(Instruction.jump(operation, a, 0));
  }

  /** An instruction that coverage needs: it counts for nothing and has the range of the next. */
  int emitUnpaid(long word) {
    unpaid.set(size);
    return add(word);
  }

  private int add(long word) {
    if (size == code.length) {
      code = Arrays.copyOf(code, size * 2);
      starts = Arrays.copyOf(starts, size * 2);
      ends = Arrays.copyOf(ends, size * 2);
    }
    code[size] = word;
    starts[size] = range.start();
    ends[size] = range.end();
    if (!unpaid.get(size)) {
      for (int i = unpaid.previousClearBit(size - 1) + 1; i < size; i++) {
        starts[i] = range.start();
        ends[i] = range.end();
      }
    }
    return size++;
  }

  /** Makes the jump at {@code pc} land on {@code target}. */
  void land(int pc, int target) {
    long word = code[pc];
    int operation = Instruction.operation(word);
    int distance = target - pc - 1;
    if (operation >= Op.JUMP_IF_LESS) {
      if (distance > 0x1FFFF || distance < -0x20000) {
        throw new ProgramTooLarge(text("blockTooLarge"));
      }
      code[pc] = Instruction.of(operation, Instruction.a(word), Instruction.b(word), distance);
    } else {
      boolean loop = operation == Op.LOOP;
      int a = loop ? Math.min(unpaid(target), Instruction.MAX_OPERAND) : Instruction.a(word);
      code[pc] = Instruction.jump(operation, a, distance);
    }
  }

  long[] code() {
    return Arrays.copyOf(code, size);
  }

  int[] starts() {
    return Arrays.copyOf(starts, size);
  }

  int[] ends() {
    return Arrays.copyOf(ends, size);
  }
}
