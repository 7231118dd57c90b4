package org.pendant.recording;

/**
 * Segment cursor: goes through a segment's entries in turn and knows where the newest value of each
 * thing is.
 */
final class SegmentCursor {
  private static final double[] NOT_ASKED_FOR = {};

  private final Segment segment;
  private final int count;
  private final int[] numberAt = new int[NumberGroup.COUNT];
  private final int[] partAt = new int[SnapshotPart.COUNT];
  private int numbers;

  /** Those of the segment, once they were asked for. */
  private double[] pool = NOT_ASKED_FOR;

  private int parts;
  private int entry = -1;

  /** Before the first of the {@code count} entries that are to be read. */
  SegmentCursor(Segment segment, int count) {
    this.segment = segment;
    this.count = count;
  }

  /** To the next entry, if there is one. */
  boolean next() {
    if (entry + 1 >= count) {
      return false;
    }
    entry++;
    for (int left = segment.numberMask(entry); left != 0; left &= left - 1) {
      int group = Integer.numberOfTrailingZeros(left);
      numberAt[group] = numbers;
      numbers += NumberGroup.sizeOf(group);
    }
    for (int left = segment.partMask(entry); left != 0; left &= left - 1) {
      partAt[Integer.numberOfTrailingZeros(left)] = parts;
      parts++;
    }
    return true;
  }

  /** To entry {@code wanted}, which is not before the present one. */
  SegmentCursor to(int wanted) {
    while (entry < wanted && next()) {
      // next() does it
    }
    return this;
  }

  /**
   * To the last entry of frame {@code frame}, which is not before the present one, or before it.
   */
  SegmentCursor toFrame(long frame) {
    return to(segment.entryAt(frame, count));
  }

  /** Frame of the present entry. */
  long frame() {
    return segment.frame(entry);
  }

  /** Whether the present entry has a new value of a group. */
  boolean changed(NumberGroup group) {
    return (segment.numberMask(entry) & group.bit()) != 0;
  }

  /** Whether the present entry has a new value of a part. */
  boolean changed(SnapshotPart part) {
    return (segment.partMask(entry) & part.bit()) != 0;
  }

  /** Number {@code index} of a group. */
  double number(NumberGroup group, int index) {
    if (pool.length == 0) {
      pool = segment.numbers();
    }
    return pool[numberAt[group.index()] + index];
  }

  /** A part. */
  Object part(SnapshotPart part) {
    return segment.part(partAt[part.index()]);
  }
}
