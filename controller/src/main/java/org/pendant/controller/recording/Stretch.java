package org.pendant.controller.recording;

/** Where a segment can be had: it is in memory, or in a file. */
interface Stretch {
  /** Its first frame. */
  long firstFrame();

  /**
   * The segment.
   *
   * @throws java.io.UncheckedIOException if it is in a file that cannot be read any more
   */
  Segment segment();
}
