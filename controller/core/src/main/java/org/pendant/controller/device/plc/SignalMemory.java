package org.pendant.controller.device.plc;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.controller.wire.SignalLine;

/** Signal memory: the values of a device's signals, by their groups. The frame loop owns it. */
final class SignalMemory {
  private final Map<String, SignalGroup> groups = new LinkedHashMap<>();
  private final Map<String, int[]> values = new LinkedHashMap<>();
  private List<SignalGroupState> state = List.of();
  private boolean stale = true;
  private long changes;

  /** A memory that is all zero. */
  SignalMemory(List<SignalGroup> groups) {
    for (SignalGroup each : groups) {
      this.groups.put(each.name(), each);
      values.put(each.name(), new int[each.count()]);
    }
  }

  /** Whether there is such a group and it has all of these numbers. */
  boolean holds(String group, int first, int count) {
    SignalGroup found = groups.get(group);
    return found != null && count > 0 && found.holds(first) && found.holds(first + count - 1);
  }

  /** One value of a group that has its number. */
  int get(String group, int index) {
    return values.get(group)[index - groups.get(group).first()];
  }

  /** Sets a value of a group that has its number. */
  void set(String group, int index, int value) {
    int[] all = values.get(group);
    int at = index - groups.get(group).first();
    if (all[at] != value) {
      all[at] = value;
      stale = true;
      changes++;
    }
  }

  /** Grows whenever a value changes. */
  long changes() {
    return changes;
  }

  /** A value as a signal. */
  SignalLine line(String group, int index) {
    return new SignalLine() {
      @Override
      public int value() {
        return get(group, index);
      }

      @Override
      public void set(int value) {
        SignalMemory.this.set(group, index, value);
      }
    };
  }

  /** All values; the same list until one changes. */
  List<SignalGroupState> state() {
    if (stale) {
      stale = false;
      List<SignalGroupState> now = new ArrayList<>();
      groups.forEach(
          (name, group) ->
              now.add(
                  new SignalGroupState(
                      name,
                      group.first(),
                      group.digital(),
                      group.settable(),
                      Arrays.stream(values.get(name)).boxed().toList())));
      state = List.copyOf(now);
    }
    return state;
  }
}
