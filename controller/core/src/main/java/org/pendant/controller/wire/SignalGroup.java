package org.pendant.controller.wire;

import org.pendant.models.json.Range;

/**
 * Signal group: signals of one owner that stand beside each other.
 *
 * @param name such as {@code digital_out}
 * @param first number of the first one
 * @param count how many there are
 * @param settable whether devices and rules may set them; they watch them otherwise
 * @param range what their values may be; 0 to 1 for digital signals
 */
public record SignalGroup(String name, int first, int count, boolean settable, Range range) {
  /** Low and high. */
  public static final Range LEVEL = new Range(0, 1, "");

  /** Whether its signals are high or low, and nothing else. */
  public boolean digital() {
    return range.equals(LEVEL);
  }

  /** Whether it has a signal of that number. */
  public boolean holds(int index) {
    return index >= first && index < first + count;
  }

  /** Number of the last one. */
  int last() {
    return first + count - 1;
  }
}
