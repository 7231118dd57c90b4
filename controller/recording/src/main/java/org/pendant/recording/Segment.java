package org.pendant.recording;

import java.util.Arrays;
import java.util.function.Supplier;

/**
 * Segment: a stretch of frames: first a whole snapshot, then for each frame that changed something
 * what that was. One thread appends; others read up to {@link #published} at the same time, as what
 * has been appended never changes.
 *
 * <p>An entry has the number of its frame, a mask of {@link NumberGroup}s and one of {@link
 * SnapshotPart}s, whose values follow each other in the two pools in the order of their bits.
 * Snapshots of a frame that a debugger paused in have entries with the same frame. The numbers of a
 * segment that is full may be in a {@link NumberStore}.
 */
final class Segment implements SegmentRef {
  /** Entries of a segment. */
  static final int MAX_ENTRIES = 1024;

  /** Numbers of a segment. */
  static final int MAX_NUMBERS = 32_768;

  /** Estimated bytes of the parts of a segment, exceeded by those of one entry at most. */
  static final long MAX_PART_BYTES = 1L << 20;

  private static final int FIRST_PARTS = 256;
  private static final int BYTES_AN_ENTRY = 3 * Integer.BYTES;
  private static final int BYTES_A_PART = 8;

  private final long firstFrame;
  private final int[] frames;
  private final int[] numberMasks;
  private final int[] partMasks;
  private final int numberRoom;
  private Object[] parts;
  private int entries;
  private int numbersUsed;
  private int partsUsed;
  private long partBytes;
  private volatile Supplier<double[]> numbers;
  private volatile boolean away;
  private volatile int published;

  /** One to be filled. */
  Segment(long firstFrame) {
    this(
        firstFrame,
        new int[MAX_ENTRIES],
        new int[MAX_ENTRIES],
        new int[MAX_ENTRIES],
        new double[MAX_NUMBERS],
        new Object[FIRST_PARTS]);
  }

  private Segment(
      long firstFrame,
      int[] frames,
      int[] numberMasks,
      int[] partMasks,
      double[] numbers,
      Object[] parts) {
    this.firstFrame = firstFrame;
    this.frames = frames;
    this.numberMasks = numberMasks;
    this.partMasks = partMasks;
    this.numbers = () -> numbers;
    numberRoom = numbers.length;
    this.parts = parts;
  }

  /**
   * A full one, of arrays that belong to it from now on; the masks say how much is in the pools.
   */
  static Segment full(
      long firstFrame,
      int[] frames,
      int[] numberMasks,
      int[] partMasks,
      double[] numbers,
      Object[] parts) {
    Segment segment = new Segment(firstFrame, frames, numberMasks, partMasks, numbers, parts);
    segment.entries = frames.length;
    segment.numbersUsed = numbers.length;
    segment.partsUsed = parts.length;
    segment.published = frames.length;
    return segment;
  }

  /** The same without spare room; nothing can be appended to it. */
  Segment trimmed() {
    Segment copy =
        full(
            firstFrame,
            Arrays.copyOf(frames, entries),
            Arrays.copyOf(numberMasks, entries),
            Arrays.copyOf(partMasks, entries),
            // a copy is worth it where much is spare only
            numbersUsed > MAX_NUMBERS - MAX_NUMBERS / 8
                ? numbers()
                : Arrays.copyOf(numbers(), numbersUsed),
            Arrays.copyOf(parts, partsUsed));
    copy.numbersUsed = numbersUsed;
    copy.partBytes = partBytes;
    return copy;
  }

  /** Its first {@code count} entries, 1 to {@link #published}. */
  Segment first(int count) {
    int numberCount = 0;
    int partCount = 0;
    for (int i = 0; i < count; i++) {
      numberCount += NumberGroup.sizeOfAll(numberMasks[i]);
      partCount += Integer.bitCount(partMasks[i]);
    }
    Segment copy =
        full(
            firstFrame,
            Arrays.copyOf(frames, count),
            Arrays.copyOf(numberMasks, count),
            Arrays.copyOf(partMasks, count),
            Arrays.copyOf(numbers(), numberCount),
            Arrays.copyOf(parts, partCount));
    // all of them at most; how much each takes is not known any more
    copy.partBytes = partBytes;
    return copy;
  }

  /** Whether an entry of this size still has room. */
  boolean fits(long frame, int numberMask) {
    return entries < MAX_ENTRIES
        && numbersUsed + NumberGroup.sizeOfAll(numberMask) <= numberRoom
        && partBytes < MAX_PART_BYTES
        && frame - firstFrame <= Integer.MAX_VALUE;
  }

  /** Begins an entry, which {@link #publish} ends. */
  void begin(long frame, int numberMask, int partMask) {
    frames[entries] = (int) (frame - firstFrame);
    numberMasks[entries] = numberMask;
    partMasks[entries] = partMask;
  }

  /** The next group of the entry: {@code count} numbers of {@code from}, from {@code at} on. */
  void add(double[] from, int at, int count) {
    System.arraycopy(from, at, numbers(), numbersUsed, count);
    numbersUsed += count;
  }

  /**
   * The next part of the entry.
   *
   * @param bytes what it takes, about
   */
  void add(Object part, long bytes) {
    if (partsUsed == parts.length) {
      parts = Arrays.copyOf(parts, 2 * partsUsed);
    }
    parts[partsUsed] = part;
    partsUsed++;
    partBytes += bytes;
  }

  /** Ends an entry: readers may see it. */
  void publish() {
    entries++;
    published = entries;
  }

  /** How many entries may be read. */
  int published() {
    return published;
  }

  /** What it takes, about, its numbers included wherever they are. */
  long bytes() {
    return partBytes
        + (long) BYTES_AN_ENTRY * frames.length
        + (long) Double.BYTES * numberRoom
        + (long) BYTES_A_PART * parts.length;
  }

  @Override
  public long firstFrame() {
    return firstFrame;
  }

  @Override
  public boolean inMemory() {
    return true;
  }

  @Override
  public Segment segment() {
    return this;
  }

  /** Frame of entry {@code entry}. */
  long frame(int entry) {
    return firstFrame + frames[entry];
  }

  int numberMask(int entry) {
    return numberMasks[entry];
  }

  int partMask(int entry) {
    return partMasks[entry];
  }

  /**
   * The pool of numbers, which may be longer than they are; not to be changed.
   *
   * @throws java.io.UncheckedIOException if they are in a file that cannot be read any more
   */
  double[] numbers() {
    return numbers.get();
  }

  /** How many numbers it has. */
  int numberCount() {
    return numbersUsed;
  }

  /** The numbers are not kept here any more, but by {@code store}, which gives the same. */
  void numbersAreIn(Supplier<double[]> store) {
    numbers = store;
    away = true;
  }

  /** Whether the numbers are kept elsewhere. */
  boolean numbersAreAway() {
    return away;
  }

  Object part(int place) {
    return parts[place];
  }

  /** The last of the first {@code count} entries with a frame of at most {@code frame}, or 0. */
  int entryAt(long frame, int count) {
    int low = 0;
    int high = count - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (frame(middle) <= frame) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
}
