package org.pendant.editors.dap.look;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.quantity.Component;
import org.pendant.controller.quantity.ScalarType;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.value.Value;

/** Robot branches: what a snapshot has of signals, registers and the arm. */
public final class RobotBranches {
  private static final List<String> OF_ROBOT =
      List.of(
          "actual_tcp",
          "target_tcp",
          "tcp_speed",
          "tcp_wrench",
          "tcp_force",
          "tcp_offset",
          "actual_q",
          "target_q",
          "actual_qd",
          "current",
          "torque",
          "temperature",
          "payload",
          "speed_slider",
          "speed_scaling");

  private RobotBranches() {}

  /** The digital and analog signals. */
  public static Branch signals(ControllerState state) {
    List<Shown> all = new ArrayList<>();
    for (SignalBank bank : SignalBank.values()) {
      all.add(shown(bank.text(), state));
    }
    for (AnalogBank bank : AnalogBank.values()) {
      all.add(shown(bank.text(), state));
    }
    return Branch.of(all, false, RobotBranches::watchable);
  }

  /** The general-purpose registers. */
  public static Branch registers(ControllerState state) {
    List<Shown> all = new ArrayList<>();
    for (RegisterDirection direction : RegisterDirection.values()) {
      for (RegisterKind kind : RegisterKind.values()) {
        all.add(shown(direction.text() + "_" + kind.text() + "_register", state));
      }
    }
    return Branch.of(all, false, RobotBranches::watchable);
  }

  /** Time, modes and the arm. */
  public static Branch robot(ControllerState state) {
    List<Shown> all = new ArrayList<>();
    all.add(Shown.leaf("time", String.format(Locale.ROOT, "%.3f s", state.timeS()), ""));
    all.add(Shown.leaf("robot_mode", word(state.safety().robotMode()), ""));
    all.add(Shown.leaf("safety_mode", word(state.safety().safetyMode()), ""));
    Optional<String> stop = state.safety().stop().map(SafetyStop::message);
    stop.ifPresent(message -> all.add(Shown.message("safety_stop", message)));
    all.add(Shown.leaf("moving", word(state.arm().moving()), ""));
    OF_ROBOT.forEach(name -> all.add(shown(name, state)));
    return Branch.of(all, false, RobotBranches::watchable);
  }

  private static Optional<String> watchable(String name) {
    return WatchedSignal.of(name).map(signal -> WatchedSignal.WATCHABLE + name);
  }

  private static String word(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT);
  }

  private static String word(boolean value) {
    return value ? "True" : "False";
  }

  /** A quantity; one of several numbers has them as its parts. */
  private static Shown shown(String name, ControllerState state) {
    StateQuantity quantity = StateQuantities.of(name);
    double[] numbers = quantity.numbers(state);
    String unit = unit(quantity.components().getFirst());
    if (numbers.length == 1) {
      return Shown.leaf(name, text(quantity.type(), numbers[0]) + unit, "");
    }
    List<String> texts =
        IntStream.range(0, numbers.length)
            .mapToObj(i -> text(quantity.type(), numbers[i]))
            .toList();
    List<Shown> parts =
        IntStream.range(0, numbers.length).mapToObj(i -> part(quantity, i, texts.get(i))).toList();
    return new Shown(
        name,
        summary(texts),
        "",
        "",
        Optional.of(
            Branch.of(parts, true, part -> Optional.of(WatchedSignal.WATCHABLE + name + part))),
        false);
  }

  private static Shown part(StateQuantity quantity, int index, String text) {
    Component component = quantity.components().get(index);
    return Shown.leaf("[" + index + "]", text + unit(component), component.title());
  }

  private static String summary(List<String> texts) {
    int most = 8;
    return texts.size() <= most
        ? "[" + String.join(", ", texts) + "]"
        : "[" + String.join(", ", texts.subList(0, most)) + ", ...]";
  }

  private static String unit(Component component) {
    String symbol = component.unit().symbol();
    return symbol.isEmpty() ? "" : " " + symbol;
  }

  static String text(ScalarType type, double number) {
    return switch (type) {
      case BOOL -> word(number != 0);
      case UINT8, INT32, UINT32, UINT64 -> String.valueOf((long) number);
      case DOUBLE -> Value.of(number).text();
    };
  }
}
