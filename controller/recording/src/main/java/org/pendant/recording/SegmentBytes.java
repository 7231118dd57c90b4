package org.pendant.recording;

import static org.pendant.recording.RecordingTexts.text;

import java.util.Arrays;

/**
 * Segment bytes: how a segment stands in a file. Each number stands as the difference of its bits
 * to those of the number before it in the same column, and the bytes of these differences are
 * sorted by their place: what changes slowly becomes long rows of zeros.
 */
final class SegmentBytes {
  /** No controller runs for a thousand years. */
  private static final long MAX_FRAMES = 1L << 44;

  private SegmentBytes() {}

  /** The first {@code count} entries of a segment. */
  static void write(Segment segment, int count, ByteSink out) {
    out.whole(segment.firstFrame());
    out.count(count);
    int numbers = 0;
    long before = segment.firstFrame();
    for (int i = 0; i < count; i++) {
      out.unsigned(segment.frame(i) - before);
      out.unsigned(segment.numberMask(i));
      out.unsigned(segment.partMask(i));
      before = segment.frame(i);
      numbers += NumberGroup.sizeOfAll(segment.numberMask(i));
    }
    writeNumbers(segment, count, numbers, out);
    int part = 0;
    for (int i = 0; i < count; i++) {
      for (int left = segment.partMask(i); left != 0; left &= left - 1) {
        SnapshotPart.of(Integer.numberOfTrailingZeros(left))
            .form()
            .writeObject(segment.part(part), out);
        part++;
      }
    }
  }

  private static void writeNumbers(Segment segment, int count, int numbers, ByteSink out) {
    byte[] planes = new byte[Long.BYTES * numbers];
    long[] last = new long[NumberGroup.NUMBERS];
    double[] pool = segment.numbers();
    int at = 0;
    for (int i = 0; i < count; i++) {
      int column = 0;
      for (int group = 0; group < NumberGroup.COUNT; group++) {
        int size = NumberGroup.sizeOf(group);
        if ((segment.numberMask(i) & 1 << group) != 0) {
          for (int k = column; k < column + size; k++) {
            long bits = Double.doubleToRawLongBits(pool[at]);
            long difference = bits - last[k];
            last[k] = bits;
            long folded = (difference << 1) ^ (difference >> 63);
            for (int plane = 0; plane < Long.BYTES; plane++) {
              planes[plane * numbers + at] = (byte) (folded >>> (8 * plane));
            }
            at++;
          }
        }
        column += size;
      }
    }
    out.raw(planes);
  }

  /**
   * Reads what {@link #write} has written.
   *
   * @throws MalformedBytes if that cannot have been written so
   * @throws IllegalArgumentException if a part refuses what it is made of
   */
  static Segment read(ByteSource in) throws MalformedBytes {
    long firstFrame = in.whole();
    int count = in.count(3);
    if (firstFrame < 0 || firstFrame > MAX_FRAMES) {
      throw new MalformedBytes(text("firstFrameOutside", firstFrame, MAX_FRAMES));
    }
    if (count < 1 || count > Segment.MAX_ENTRIES) {
      throw new MalformedBytes(text("entriesOutside", count, Segment.MAX_ENTRIES));
    }
    int[] frames = new int[count];
    int[] numberMasks = new int[count];
    int[] partMasks = new int[count];
    int numbers = 0;
    int parts = 0;
    long frame = 0;
    for (int i = 0; i < count; i++) {
      frame += in.upTo(Integer.MAX_VALUE);
      if (frame > Integer.MAX_VALUE) {
        throw new MalformedBytes(text("blockFrames", frame));
      }
      frames[i] = (int) frame;
      numberMasks[i] = in.upTo(NumberGroup.ALL);
      partMasks[i] = in.upTo(SnapshotPart.ALL);
      numbers += NumberGroup.sizeOfAll(numberMasks[i]);
      parts += Integer.bitCount(partMasks[i]);
    }
    if (frames[0] != 0 || numberMasks[0] != NumberGroup.ALL || partMasks[0] != SnapshotPart.ALL) {
      throw new MalformedBytes(text("firstEntryNotWhole"));
    }
    if (numbers > Segment.MAX_NUMBERS) {
      throw new MalformedBytes(text("blockNumbers", numbers, Segment.MAX_NUMBERS));
    }
    double[] values = readNumbers(numberMasks, numbers, in);
    Object[] objects = readParts(partMasks, parts, in);
    if (in.left() > 0) {
      throw new MalformedBytes(text("bytesLeft", in.left()));
    }
    return Segment.full(firstFrame, frames, numberMasks, partMasks, values, objects);
  }

  private static double[] readNumbers(int[] masks, int numbers, ByteSource in)
      throws MalformedBytes {
    byte[] planes = in.raw(Long.BYTES * numbers);
    double[] values = new double[numbers];
    long[] last = new long[NumberGroup.NUMBERS];
    int at = 0;
    for (int mask : masks) {
      int column = 0;
      for (int group = 0; group < NumberGroup.COUNT; group++) {
        int size = NumberGroup.sizeOf(group);
        if ((mask & 1 << group) != 0) {
          for (int k = column; k < column + size; k++) {
            long folded = 0;
            for (int plane = 0; plane < Long.BYTES; plane++) {
              folded |= (planes[plane * numbers + at] & 0xFFL) << (8 * plane);
            }
            last[k] += (folded >>> 1) ^ -(folded & 1);
            values[at] = Double.longBitsToDouble(last[k]);
            at++;
          }
        }
        column += size;
      }
    }
    return values;
  }

  private static Object[] readParts(int[] masks, int parts, ByteSource in) throws MalformedBytes {
    // grown as they come: a hostile block announces more than it has
    Object[] objects = new Object[Math.min(parts, 64)];
    int at = 0;
    for (int mask : masks) {
      for (int left = mask; left != 0; left &= left - 1) {
        if (at == objects.length) {
          objects = Arrays.copyOf(objects, Math.min(parts, 2 * at));
        }
        objects[at] = SnapshotPart.of(Integer.numberOfTrailingZeros(left)).form().read(in);
        at++;
      }
    }
    return objects;
  }
}
