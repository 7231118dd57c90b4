package org.pendant.controller.wire;

import java.util.List;

/**
 * State of the signals of a group at one moment.
 *
 * @param name of the group, such as {@code coil}
 * @param first number of the first signal
 * @param digital whether they are levels, 0 or 1
 * @param settable whether devices, rules and people may set them
 * @param values of the signals, in their order
 */
public record SignalGroupState(
    String name, int first, boolean digital, boolean settable, List<Integer> values) {
  /** Copies the list. */
  public SignalGroupState {
    values = List.copyOf(values);
  }
}
