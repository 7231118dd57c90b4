package org.pendant.command.rpc;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.quantity.ScalarType;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.check.Nearest;

/**
 * Quantity name: a quantity of the catalogue, or one number of it: {@code actual_q}, {@code
 * actual_q[2]}, {@code actual_tcp_z}, {@code digital_out[0]}.
 *
 * @param quantity that it is of
 * @param index which of its numbers; empty for all
 */
record QuantityName(StateQuantity quantity, OptionalInt index) {
  private static final Pattern INDEXED = Pattern.compile("(\\w+)\\[(\\d{1,3})]");

  /** What a text names. */
  static QuantityName of(String text) throws RpcFailure {
    Matcher indexed = INDEXED.matcher(text);
    String name = indexed.matches() ? indexed.group(1) : text;
    for (StateQuantity each : StateQuantities.all()) {
      if (each.name().equals(name)) {
        return indexed.matches()
            ? element(each, text, Integer.parseInt(indexed.group(2)))
            : new QuantityName(each, each.size() == 1 ? OptionalInt.of(0) : OptionalInt.empty());
      }
    }
    for (StateQuantity each : StateQuantities.all()) {
      for (int i = 0; i < each.size(); i++) {
        if (each.components().get(i).name().equals(text)) {
          return new QuantityName(each, OptionalInt.of(i));
        }
      }
    }
    throw RpcFailure.params(
        Nearest.among(name, names())
            .map(near -> RpcTexts.text("noSuchQuantityButNear", text, near))
            .orElseGet(() -> RpcTexts.text("noSuchQuantity", text)));
  }

  private static QuantityName element(StateQuantity quantity, String text, int index)
      throws RpcFailure {
    if (index >= quantity.size()) {
      throw RpcFailure.params(RpcTexts.text("wrongIndex", text, index, quantity.size() - 1));
    }
    return new QuantityName(quantity, OptionalInt.of(index));
  }

  private static List<String> names() {
    return StateQuantities.all().stream().map(StateQuantity::name).toList();
  }

  /** Its number, for a comparison. */
  double number(ControllerState state) {
    return quantity.getter().element(index.orElse(0)).applyAsDouble(state);
  }

  /** How many numbers it has. */
  int size() {
    return index.isPresent() ? 1 : quantity.size();
  }

  /** What it is in a snapshot: a number or a level, or a list of these. */
  Object value(ControllerState state) {
    return index.isPresent() ? value(quantity.type(), number(state)) : value(quantity, state);
  }

  /** What a quantity is in a snapshot: a number or a level, or a list of these. */
  static Object value(StateQuantity quantity, ControllerState state) {
    double[] numbers = quantity.numbers(state);
    if (numbers.length == 1) {
      return value(quantity.type(), numbers[0]);
    }
    List<Object> values = new ArrayList<>(numbers.length);
    for (double each : numbers) {
      values.add(value(quantity.type(), each));
    }
    return values;
  }

  private static Object value(ScalarType type, double number) {
    return switch (type) {
      case BOOL -> number != 0;
      case UINT8, INT32, UINT32, UINT64 -> (long) number;
      case DOUBLE -> number;
    };
  }
}
