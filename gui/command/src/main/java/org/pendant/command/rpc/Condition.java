package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.Drive;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.models.json.Json;
import org.pendant.models.json.Range;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.Value;

/**
 * Condition: what quantities and variables must be, all of them at the same time. The names are
 * those of {@link QuantityName} and {@code var:NAME}; the values are numbers, levels, texts, or
 * {@code {"above": A, "below": B}}.
 */
final class Condition {
  private static final String VARIABLE = "var:";
  private static final Range ANY = new Range(-Double.MAX_VALUE, Double.MAX_VALUE, "");

  /** What one of them must be. */
  private sealed interface Wish {
    /** Whether a number is so. */
    boolean holds(double number);

    /** Between two numbers, without them. */
    record Between(double above, double below) implements Wish {
      @Override
      public boolean holds(double number) {
        return number > above && number < below;
      }
    }

    /** A number or, as 0 and 1, a level. */
    record Exactly(double wanted) implements Wish {
      @Override
      public boolean holds(double number) {
        return number == wanted;
      }
    }

    /** A text, which no number is. */
    record Letters(String wanted) implements Wish {
      @Override
      public boolean holds(double number) {
        return false;
      }
    }
  }

  private record OfQuantity(QuantityName quantity, Wish wish) {}

  private final List<OfQuantity> quantities = new ArrayList<>();
  private final Map<String, Wish> variables = new LinkedHashMap<>();

  private Condition() {}

  /** The condition that {@code value} says. */
  static Condition of(Json value) throws RpcFailure {
    Condition condition = new Condition();
    var members = RpcParams.members("until", value);
    if (members.isEmpty()) {
      throw RpcFailure.params(text("untilEmpty"));
    }
    for (var each : members.entrySet()) {
      String name = each.getKey();
      Wish wish = wish(name, each.getValue().value());
      if (name.startsWith(VARIABLE)) {
        condition.variables.put(name.substring(VARIABLE.length()), wish);
      } else {
        condition.add(name, wish);
      }
    }
    return condition;
  }

  private void add(String name, Wish wish) throws RpcFailure {
    QuantityName quantity = QuantityName.of(name);
    if (quantity.size() != 1) {
      throw RpcFailure.params(text("severalNumbers", name, quantity.size(), name));
    }
    if (wish instanceof Wish.Letters) {
      throw RpcFailure.params(text("numberNoText", name));
    }
    quantities.add(new OfQuantity(quantity, wish));
  }

  private static Wish wish(String name, Json value) throws RpcFailure {
    return switch (value) {
      case Json.Numeral number -> new Wish.Exactly(number.value());
      case Json.Word word -> new Wish.Exactly(RpcParams.level(name, word) ? 1 : 0);
      case Json.Text text -> new Wish.Letters(text.value());
      case Json.Members range -> between(name, range);
      case Json.Elements _ -> throw RpcParams.wrong(name, value, text("valueOrRange"));
    };
  }

  private static Wish between(String name, Json.Members range) throws RpcFailure {
    double above = Double.NEGATIVE_INFINITY;
    double below = Double.POSITIVE_INFINITY;
    for (var each : range.byKey().entrySet()) {
      double number = RpcParams.number(name, each.getValue().value(), ANY);
      switch (each.getKey()) {
        case "above" -> above = number;
        case "below" -> below = number;
        default -> throw RpcParams.wrong(name, range, text("aboveAndBelow"));
      }
    }
    return new Wish.Between(above, below);
  }

  /** Whether all of it is so. */
  boolean holds(ControllerState state, Drive drive) {
    for (OfQuantity each : quantities) {
      if (!each.wish().holds(each.quantity().number(state))) {
        return false;
      }
    }
    if (variables.isEmpty()) {
      return true;
    }
    Map<String, Value> globals = drive.globals();
    return variables.entrySet().stream()
        .allMatch(
            each ->
                Optional.ofNullable(globals.get(ByteText.asBytes(each.getKey())))
                    .filter(value -> holds(value, each.getValue()))
                    .isPresent());
  }

  private static boolean holds(Value value, Wish wish) {
    return switch (value) {
      case IntValue number -> wish.holds(number.value());
      case FloatValue number -> wish.holds(number.value());
      case BoolValue level -> wish.holds(level.value() ? 1 : 0);
      case StringValue text ->
          wish instanceof Wish.Letters(String wanted)
              && ByteText.decoded(text.bytes()).equals(wanted);
      case Value _ -> false;
    };
  }
}
