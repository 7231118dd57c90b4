package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;

/**
 * Register segments: shares one register file between the static slots of a program and its
 * threads, in segments of a power of two.
 */
final class RegisterSegments {
  private static final int SMALLEST = 64;
  private static final int SIZE_CLASSES = 24;

  /** Most registers that a program may have. */
  private static final int MAX_SLOTS = 1 << 20;

  /** Registers that are copied or cleared in a nanosecond, roughly. */
  private static final int SLOTS_A_NS = 2;

  private final Registers registers;
  private final List<List<Integer>> free = new ArrayList<>();
  private int end;

  RegisterSegments(Registers registers, int staticCount) {
    this.registers = registers;
    this.end = staticCount;
    for (int i = 0; i < SIZE_CLASSES; i++) {
      free.add(new ArrayList<>());
    }
  }

  /** The size of the segment that {@link #take} gives for {@code needed} slots. */
  static int sizeFor(int needed) {
    return Math.max(SMALLEST, Integer.highestOneBit(Math.max(1, needed - 1)) << 1);
  }

  /** Refuses to {@link #enlarge} a segment if the program would have too many slots. */
  void checkEnlarge(ScriptThread thread, int slot) throws ScriptError {
    check(Math.max(slot + 1 - thread.segmentStart, thread.segmentEnd - thread.segmentStart + 1));
  }

  /** Refuses a segment for {@code needed} slots if the program would have too many. */
  void check(int needed) throws ScriptError {
    int size = sizeFor(needed);
    if (size > MAX_SLOTS - end && free.get(Integer.numberOfTrailingZeros(size)).isEmpty()) {
      throw new ScriptError("out-of-memory", text("callsTooLarge", MAX_SLOTS));
    }
  }

  /** The first slot of a segment of {@link #sizeFor} slots. */
  int take(int needed) {
    int size = sizeFor(needed);
    List<Integer> reusable = free.get(Integer.numberOfTrailingZeros(size));
    if (!reusable.isEmpty()) {
      return reusable.removeLast();
    }
    int start = end;
    end += size;
    registers.grow(end);
    return start;
  }

  void give(int start, int size) {
    for (int slot = start; slot < start + size; slot++) {
      registers.clear(slot);
    }
    free.get(Integer.numberOfTrailingZeros(size)).add(start);
  }

  /**
   * Makes the segment of {@code thread} larger, so that it holds {@code slot}.
   *
   * @return what that takes, in nanoseconds
   */
  int enlarge(ScriptThread thread, int slot) {
    int start = thread.segmentStart;
    int size = thread.segmentEnd - start;
    int needed = slot + 1 - start;
    int larger = take(Math.max(needed, size + 1));
    System.arraycopy(registers.numbers(), start, registers.numbers(), larger, size);
    System.arraycopy(registers.tags(), start, registers.tags(), larger, size);
    System.arraycopy(registers.objects(), start, registers.objects(), larger, size);
    give(start, size);
    thread.shift(larger - start);
    thread.segmentEnd = larger + sizeFor(Math.max(needed, size + 1));
    return (thread.segmentEnd - thread.segmentStart) / SLOTS_A_NS;
  }
}
