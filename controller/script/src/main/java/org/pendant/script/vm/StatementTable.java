package org.pendant.script.vm;

import java.util.Arrays;
import org.pendant.language.source.SourceRange;

/**
 * Statement table: where the statements of one function begin, in the order of its instructions. A
 * loop whose condition is compiled twice stands in it twice, with the same range.
 */
final class StatementTable {
  private int[] pcs = new int[8];
  private int[] starts = new int[8];
  private int[] ends = new int[8];
  private int size;

  /**
   * Adds the statement that begins with instruction {@code pc}, not before the last one added. One
   * without instructions of its own gives way to the next.
   *
   * @param free the first of the instructions before {@code pc} that belong to no statement; {@code
   *     pc} if none
   * @param head the statement, without the blocks in it
   */
  void add(int free, int pc, SourceRange head) {
    if (size > 0 && pcs[size - 1] >= free) {
      size--;
    }
    if (size == pcs.length) {
      pcs = Arrays.copyOf(pcs, size * 2);
      starts = Arrays.copyOf(starts, size * 2);
      ends = Arrays.copyOf(ends, size * 2);
    }
    pcs[size] = pc;
    starts[size] = head.start();
    ends[size] = head.end();
    size++;
  }

  int size() {
    return size;
  }

  /** The first instruction of statement {@code number}. */
  int pc(int number) {
    return pcs[number];
  }

  /** The first offset of statement {@code number} in the source. */
  int start(int number) {
    return starts[number];
  }

  SourceRange range(int number) {
    return new SourceRange(starts[number], ends[number]);
  }

  /** The number of the statement that begins with instruction {@code pc}; negative for none. */
  int beginningAt(int pc) {
    return Arrays.binarySearch(pcs, 0, size, pc);
  }

  /** The number of the statement that instruction {@code pc} belongs to; negative for none. */
  int around(int pc) {
    int found = beginningAt(pc);
    return found >= 0 ? found : -found - 2;
  }
}
