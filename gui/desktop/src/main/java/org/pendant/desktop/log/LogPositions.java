package org.pendant.desktop.log;

import java.util.Arrays;

/**
 * Log positions: rising positions in a {@link LogStore}: added at the end, taken from the start.
 */
final class LogPositions {
  private long[] ring = new long[1024];
  private int head;
  private int size;

  int size() {
    return size;
  }

  /** The one at {@code index}, 0 for the oldest. */
  long get(int index) {
    if (index < 0 || index >= size) {
      throw new IndexOutOfBoundsException("index is " + index + ", must be 0 to " + (size - 1));
    }
    return ring[(head + index) & (ring.length - 1)];
  }

  /** Adds one that is above all others. */
  void add(long position) {
    if (size == ring.length) {
      ring = unrolled(2 * ring.length);
      head = 0;
    }
    ring[(head + size) & (ring.length - 1)] = position;
    size++;
  }

  /** Drops all below {@code position}; returns how many there were. */
  int dropBelow(long position) {
    int dropped = 0;
    while (size > 0 && ring[head] < position) {
      head = (head + 1) & (ring.length - 1);
      size--;
      dropped++;
    }
    return dropped;
  }

  void clear() {
    head = 0;
    size = 0;
  }

  /** Index of the first one that is at least {@code position}; the size if there is none. */
  int firstAtLeast(long position) {
    int low = 0;
    int high = size;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (get(middle) < position) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  private long[] unrolled(int capacity) {
    long[] all = Arrays.copyOf(ring, capacity);
    for (int i = 0; i < size; i++) {
      all[i] = get(i);
    }
    return all;
  }
}
