package org.pendant.desktop.log;

import java.util.Arrays;

/**
 * Log store: the newest messages, up to a bound. Each has a position, counted from 0 without gaps
 * as they come, that it keeps when older ones go.
 */
final class LogStore {
  /** What the texts of the messages that are kept take together, at most. */
  static final int MAX_BYTES = 32 << 20;

  private final LogLine[] ring;
  private long bytes;
  private long first;
  private long end;

  /** Keeps at most {@code capacity} messages. */
  LogStore(int capacity) {
    ring = new LogLine[capacity];
  }

  /** Takes one; the oldest goes if there is no room. */
  void add(LogLine line) {
    bytes += line.text().length();
    while (first < end && (end - first >= ring.length || bytes > MAX_BYTES)) {
      bytes -= ring[slot(first)].text().length();
      ring[slot(first)] = null;
      first++;
    }
    ring[slot(end)] = line;
    end++;
  }

  /** Position of the oldest one kept; equal to {@link #end} if there is none. */
  long first() {
    return first;
  }

  /** One more than the position of the newest. */
  long end() {
    return end;
  }

  /**
   * The message at a position.
   *
   * @throws IndexOutOfBoundsException if it is not kept
   */
  LogLine at(long position) {
    if (position < first || position >= end) {
      throw new IndexOutOfBoundsException(
          "log position is " + position + ", must be " + first + " to " + (end - 1));
    }
    return ring[slot(position)];
  }

  /** Forgets all; positions continue. */
  void clear() {
    Arrays.fill(ring, null);
    bytes = 0;
    first = end;
  }

  private int slot(long position) {
    return (int) (position % ring.length);
  }
}
