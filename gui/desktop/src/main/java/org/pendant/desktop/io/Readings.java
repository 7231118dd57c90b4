package org.pendant.desktop.io;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.ScreenUnit;

/** Readings: sensor readings as texts; the rows are always the same, so that only texts change. */
final class Readings {
  private static final List<Reading> OF_JOINT =
      List.of(
          new Reading(IoTexts.text("position"), 1, "actual_q"),
          new Reading(IoTexts.text("current"), 2, "current"),
          new Reading(IoTexts.text("torque"), 1, "torque"),
          new Reading(IoTexts.text("temperature"), 1, "temperature"));

  private static final List<Reading> OF_ROBOT =
      List.of(
          new Reading(IoTexts.text("toolTemperature"), 1, "tool_temperature"),
          new Reading(IoTexts.text("controllerTemperature"), 1, "box_temperature"),
          new Reading(IoTexts.text("toolCurrent"), 3, "tool_current"),
          new Reading(IoTexts.text("tcpForce"), 1, "tcp_force"),
          new Reading(IoTexts.text("forceAlongBaseXYZ"), 1, StateQuantities.of("tcp_wrench"), 0, 3),
          new Reading(
              IoTexts.text("torqueAboutBaseXYZ"), 2, StateQuantities.of("tcp_wrench"), 3, 3),
          new Reading(IoTexts.text("payload"), 2, "payload"),
          new Reading(IoTexts.text("centreOfGravity"), 1, "payload_cog"));

  /** Titles of the columns of {@link #joint}. */
  static final List<String> JOINT_COLUMNS = OF_JOINT.stream().map(Reading::title).toList();

  /** Titles of the joints from base to wrist 3. */
  static final List<String> JOINTS =
      List.of(
          IoTexts.text("base"),
          IoTexts.text("shoulder"),
          IoTexts.text("elbow"),
          IoTexts.text("wrist1"),
          IoTexts.text("wrist2"),
          IoTexts.text("wrist3"));

  /** Titles of {@link #others}. */
  static final List<String> OTHERS = OF_ROBOT.stream().map(Reading::title).toList();

  private Readings() {}

  /** Some components of a quantity, of one unit, with so many digits behind the point. */
  private record Reading(String title, int digits, StateQuantity quantity, int from, int count) {
    Reading(String title, int digits, String quantity) {
      this(title, digits, StateQuantities.of(quantity), 0, StateQuantities.of(quantity).size());
    }

    String text(ControllerState state, int first, int size) {
      double[] numbers = quantity.numbers(state);
      ScreenUnit unit = ScreenUnit.of(quantity.components().get(first).unit());
      return unit.after(
          IntStream.range(first, first + size)
              .mapToObj(i -> number(digits, unit.scale() * numbers[i]))
              .collect(Collectors.joining(", ")));
    }
  }

  /** What is known of one joint, 0 to 5, in the order of the columns. */
  static List<String> joint(ControllerState state, int joint) {
    return OF_JOINT.stream().map(each -> each.text(state, joint, 1)).toList();
  }

  /** The texts beside {@link #OTHERS}. */
  static List<String> others(ControllerState state) {
    return OF_ROBOT.stream().map(each -> each.text(state, each.from, each.count)).toList();
  }

  /** Without a minus sign in front of nothing but zeros. */
  private static String number(int digits, double value) {
    double scale = Math.pow(10, digits);
    double rounded = Math.round(value * scale) / scale;
    return String.format(Locale.ROOT, "%." + digits + "f", rounded == 0 ? 0.0 : rounded);
  }
}
