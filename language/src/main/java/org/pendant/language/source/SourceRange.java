package org.pendant.language.source;

/**
 * Source range: a stretch of a {@link Source}, as byte offsets: {@code start} inclusive, {@code
 * end} exclusive.
 *
 * @param start first offset, at least 0
 * @param end offset just past the last byte, at least {@code start}
 */
public record SourceRange(int start, int end) {
  public SourceRange {
    if (start < 0 || end < start) {
      throw new IllegalArgumentException("range " + start + ".." + end + " is not ordered");
    }
  }

  /** The smallest range that holds this one and {@code other}. */
  public SourceRange to(SourceRange other) {
    return new SourceRange(Math.min(start, other.start), Math.max(end, other.end));
  }
}
