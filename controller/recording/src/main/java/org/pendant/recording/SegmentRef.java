package org.pendant.recording;

/** Reference to a segment, which is in memory or in a file. */
interface SegmentRef {
  /** Its first frame. */
  long firstFrame();

  /** Whether it is in memory, so that {@link #segment} is there at once. */
  boolean inMemory();

  /**
   * The segment.
   *
   * @throws java.io.UncheckedIOException if it is in a file that cannot be read any more
   */
  Segment segment();
}
