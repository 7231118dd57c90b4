package org.pendant.script.vm;

import java.util.Arrays;

/**
 * Unmarked statements: those of one function that leave no mark of their own, since what comes to
 * the next one has gone through them. Only a thread that ends within one tells of it, see {@link
 * #reachedAt}.
 */
final class UnmarkedStatements {
  /** What {@link #reachedAt} answers where no such statement is. */
  static final int NONE = -1;

  private int[] starts = new int[0];
  private int[] ends = new int[0];
  private int[] slots = new int[0];
  private int size;

  /**
   * Adds a statement that comes after all that were added.
   *
   * @param start its first instruction
   * @param end the first one of the next statement
   * @param slot the mark that it would have left
   */
  void add(int start, int end, int slot) {
    if (size == slots.length) {
      int larger = Math.max(8, size * 2);
      starts = Arrays.copyOf(starts, larger);
      ends = Arrays.copyOf(ends, larger);
      slots = Arrays.copyOf(slots, larger);
    }
    starts[size] = start;
    ends[size] = end;
    slots[size] = slot;
    size++;
  }

  /**
   * The mark of the statement that a thread has come to which goes no further.
   *
   * @param pc the instruction that would have come next
   */
  int reachedAt(int pc) {
    int at = Arrays.binarySearch(starts, 0, size, pc - 1);
    int before = at >= 0 ? at : -at - 2;
    return before >= 0 && pc - 1 < ends[before] ? slots[before] : NONE;
  }
}
