package org.pendant.desktop.waveform;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.io.InputChange;

/**
 * Waveform row: one input over the time since the start of a program.
 *
 * @param signal such as {@code digital_in[0]}
 * @param changes of this signal, in the order of their times, each to another value than the one
 *     before; before the first one the input is left as it is
 */
record WaveRow(String signal, List<InputChange> changes) {
  private static final Set<String> LEVELS =
      Set.of("digital_in", "configurable_in", "tool_in", "input_boolean_register", "port_bit");

  /** Later ones of the same time count, and those that change nothing are left out. */
  WaveRow {
    List<InputChange> kept = new ArrayList<>();
    for (InputChange each : changes) {
      if (!kept.isEmpty() && kept.getLast().timeS() >= each.timeS()) {
        kept.removeLast();
      }
      if (kept.isEmpty() || !kept.getLast().value().equals(each.value())) {
        kept.add(each);
      }
    }
    changes = List.copyOf(kept);
  }

  /** An input that is low, or at 0, from the start on. */
  static WaveRow idle(String signal) {
    return new WaveRow(signal, List.of(new InputChange(0, signal, idleValue(signal))));
  }

  private static String idleValue(String signal) {
    if (isLevel(signal)) {
      return "false";
    }
    return signal.contains("analog") ? "0V" : "0";
  }

  private static boolean isLevel(String signal) {
    int bracket = signal.indexOf('[');
    return LEVELS.contains(bracket < 0 ? signal : signal.substring(0, bracket));
  }

  /** Whether the input is low or high; otherwise it has numbers. */
  boolean level() {
    return isLevel(signal);
  }

  /** What the input is at a time; empty before the first change. */
  Optional<String> at(double timeS) {
    Optional<String> value = Optional.empty();
    for (InputChange each : changes) {
      if (each.timeS() > timeS) {
        break;
      }
      value = Optional.of(each.value());
    }
    return value;
  }

  /** Whether the input is high at a time. */
  boolean high(double timeS) {
    return at(timeS).filter(value -> high(value)).isPresent();
  }

  /** Whether {@code value} is the high level. */
  static boolean high(String value) {
    return !value.isEmpty() && "tT1".indexOf(value.charAt(0)) >= 0;
  }

  /** The other level than the one at a time. */
  String opposite(double timeS) {
    return Boolean.toString(!high(timeS));
  }

  /**
   * The same with another value between two times, from the earlier one on.
   *
   * @throws IllegalArgumentException if the input does not take the value
   */
  WaveRow with(double fromS, double toS, String value) {
    List<InputChange> all = new ArrayList<>();
    String after = at(toS).orElse(idleValue(signal));
    changes.stream().filter(each -> each.timeS() < fromS).forEach(all::add);
    all.add(new InputChange(fromS, signal, value));
    all.add(new InputChange(toS, signal, after));
    changes.stream().filter(each -> each.timeS() > toS).forEach(all::add);
    return new WaveRow(signal, all);
  }

  /** The same with another value from a time to the next change. */
  WaveRow with(double fromS, String value) {
    Optional<Double> next =
        changes.stream().map(InputChange::timeS).filter(timeS -> timeS > fromS).findFirst();
    if (next.isPresent()) {
      return with(fromS, next.get(), value);
    }
    List<InputChange> all = new ArrayList<>(changes);
    all.removeIf(each -> each.timeS() >= fromS);
    all.add(new InputChange(fromS, signal, value));
    return new WaveRow(signal, all);
  }

  /** The same with change {@code index} at another time, as far as its neighbours let it. */
  WaveRow moved(int index, double timeS, double gapS) {
    double low = index == 0 ? 0 : changes.get(index - 1).timeS() + gapS;
    double high =
        index == changes.size() - 1
            ? InputChange.MAX_TIME_S
            : Math.max(low, changes.get(index + 1).timeS() - gapS);
    List<InputChange> all = new ArrayList<>(changes);
    all.set(
        index, new InputChange(Math.clamp(timeS, low, high), signal, changes.get(index).value()));
    return new WaveRow(signal, all);
  }

  /** The same without change {@code index}. */
  WaveRow without(int index) {
    List<InputChange> all = new ArrayList<>(changes);
    all.remove(index);
    return new WaveRow(signal, all);
  }

  /** The change nearest to a time, no further from it than {@code nearS}; -1 if there is none. */
  int changeNear(double timeS, double nearS) {
    int nearest = -1;
    double best = nearS;
    for (int i = 0; i < changes.size(); i++) {
      double distance = Math.abs(changes.get(i).timeS() - timeS);
      if (distance <= best) {
        nearest = i;
        best = distance;
      }
    }
    return nearest;
  }

  /** When the last change comes, s; 0 if there is none. */
  double endS() {
    return changes.isEmpty() ? 0 : changes.getLast().timeS();
  }
}
