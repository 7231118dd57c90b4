package org.pendant.language.parse;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;
import java.util.RandomAccess;
import org.pendant.language.parse.Lexeme.Kind;

/**
 * Lexeme table: the lexemes of one text in their order. Editors keep those of all texts that are
 * open, so it is small; it never changes.
 */
public final class LexemeTable extends AbstractList<Lexeme> implements RandomAccess {
  private static final List<Kind> KINDS = List.of(Kind.values());
  private static final int FIRST_ON_LINE = 0x80;

  private final int[] starts;
  private final int[] ends;

  /** The number of its kind, and {@link #FIRST_ON_LINE}. */
  private final byte[] marks;

  private LexemeTable(int[] starts, int[] ends, byte[] marks) {
    this.starts = starts;
    this.ends = ends;
    this.marks = marks;
  }

  @Override
  public int size() {
    return starts.length;
  }

  @Override
  public Lexeme get(int index) {
    return new Lexeme(kind(index), starts[index], ends[index], firstOnLine(index));
  }

  /** What lexeme {@code index} is. */
  public Kind kind(int index) {
    return KINDS.get(marks[index] & (FIRST_ON_LINE - 1));
  }

  /** The offset of the first byte of lexeme {@code index}. */
  public int start(int index) {
    return starts[index];
  }

  /** The offset just past the last byte of lexeme {@code index}. */
  public int end(int index) {
    return ends[index];
  }

  /** Whether only blanks stand before lexeme {@code index} on its line. */
  public boolean firstOnLine(int index) {
    return (marks[index] & FIRST_ON_LINE) != 0;
  }

  /**
   * The index of the first lexeme that does not begin before {@code offset}; the size if all do.
   */
  public int indexAt(int offset) {
    int found = Arrays.binarySearch(starts, offset);
    return found >= 0 ? found : -found - 1;
  }

  /**
   * This table with other lexemes in the place of some.
   *
   * @param from the index of the first that is replaced
   * @param to the index after the last that is replaced
   * @param shift how far those behind have moved
   */
  LexemeTable with(int from, int to, LexemeTable others, int shift) {
    return new LexemeTable(
        Splice.moved(starts, from, to, others.starts, shift),
        Splice.moved(ends, from, to, others.ends, shift),
        Splice.of(marks, from, to, others.marks));
  }

  /** Collects lexemes in their order. */
  static final class Builder {
    private int[] starts;
    private int[] ends;
    private byte[] marks;
    private int size;

    Builder(int expected) {
      starts = new int[expected];
      ends = new int[expected];
      marks = new byte[expected];
    }

    void add(Kind kind, int start, int end, boolean firstOnLine) {
      if (size == starts.length) {
        int longer = size * 2;
        starts = Arrays.copyOf(starts, longer);
        ends = Arrays.copyOf(ends, longer);
        marks = Arrays.copyOf(marks, longer);
      }
      starts[size] = start;
      ends[size] = end;
      marks[size++] = (byte) (kind.ordinal() | (firstOnLine ? FIRST_ON_LINE : 0));
    }

    /** Whether the one added last is of this kind. */
    boolean endsWith(Kind kind) {
      return size > 0 && (marks[size - 1] & (FIRST_ON_LINE - 1)) == kind.ordinal();
    }

    LexemeTable table() {
      return new LexemeTable(
          Arrays.copyOf(starts, size), Arrays.copyOf(ends, size), Arrays.copyOf(marks, size));
    }
  }
}
