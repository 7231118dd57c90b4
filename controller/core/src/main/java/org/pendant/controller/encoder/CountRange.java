package org.pendant.controller.encoder;

/** Count range of an encoder, beyond which its tick counts wrap (manual 15.4). */
public enum CountRange {
  SIGNED_32(Integer.MIN_VALUE, Integer.MAX_VALUE),
  UNSIGNED_8(0, 0xFF),
  UNSIGNED_16(0, 0xFFFF),
  UNSIGNED_24(0, 0xFF_FFFF),
  UNSIGNED_32(0, 0xFFFF_FFFFL);

  private final long lowest;
  private final long highest;

  CountRange(long lowest, long highest) {
    this.lowest = lowest;
    this.highest = highest;
  }

  /**
   * The range with a number of the manual.
   *
   * @param id 0 to 4
   */
  public static CountRange of(int id) {
    return values()[id];
  }

  /** The lowest count. */
  public long lowest() {
    return lowest;
  }

  /** The highest count. */
  public long highest() {
    return highest;
  }

  /** How many counts there are. */
  public long size() {
    return highest - lowest + 1;
  }

  /** The count in the range that stands for one outside of it. */
  long wrapped(long count) {
    return lowest + Math.floorMod(count - lowest, size());
  }

  /**
   * A difference of two counts without the jump that it has when the count has wrapped between
   * them: more than half the range is taken for that (manual 15.7).
   */
  double unwound(double difference) {
    double half = 0.5 * size();
    if (difference > half) {
      return difference - size();
    }
    return difference < -half ? difference + size() : difference;
  }
}
