package org.pendant.script.debug;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.vm.NamedValue;

/** Variable factory: makes {@link Variable}s of values. */
public final class Variables {
  /** Most elements of a value that are made at once. */
  static final int MAX_CHILDREN = 1000;

  /** An operand that an index or a member may follow without brackets around it. */
  private static final Pattern OPERAND = Pattern.compile("[A-Za-z_]\\w*(\\.\\w+|\\[[\\w, ]+])*");

  private Variables() {}

  static List<Variable> of(List<NamedValue> values) {
    return values.stream()
        .map(
            each ->
                each.value()
                    .map(value -> of(each.name(), each.name(), value))
                    .orElse(new Variable(each.name(), each.name(), Optional.empty(), "", 0)))
        .toList();
  }

  /** A value that {@code expression} yields, ready to be shown. */
  public static Variable of(String name, String expression, Value value) {
    return new Variable(
        name, expression, Optional.of(value.kind()), ShortText.of(value), childCount(value));
  }

  /** How many elements or members a value has; those of a matrix are numbers. */
  public static int childCount(Value value) {
    return switch (value) {
      case ListValue list -> list.length();
      case PoseValue pose -> Pose.SIZE;
      case MatrixValue matrix -> matrix.rows() * matrix.columns();
      case StructValue struct -> struct.length();
      default -> 0;
    };
  }

  /**
   * The elements or members of {@code value}.
   *
   * @param expression what yields the value
   * @param from index of the first wanted
   * @param count how many are wanted; fewer come at the end
   */
  static List<Variable> children(String expression, Value value, int from, int count) {
    if (from < 0) {
      throw new IllegalArgumentException("from is " + from + ", must be at least 0");
    }
    if (count < 1 || count > MAX_CHILDREN) {
      throw new IllegalArgumentException("count is " + count + ", must be 1 to " + MAX_CHILDREN);
    }
    List<Variable> children = new ArrayList<>();
    for (int i = from; i < childCount(value) && i - from < count; i++) {
      Part part = part(expression, value, i);
      children.add(of(part.name(), part.expression(), part.value()));
    }
    return children;
  }

  /**
   * An element or member of a value.
   *
   * @param name as in {@link Variable#name}
   * @param expression what yields it
   */
  public record Part(String name, String expression, Value value) {}

  /**
   * Element or member {@code index} of {@code value}, from 0 to below {@link #childCount}.
   *
   * @param expression what yields the value
   */
  public static Part part(String expression, Value value, int index) {
    String operand = OPERAND.matcher(expression).matches() ? expression : "(" + expression + ")";
    try {
      return switch (value) {
        case ListValue list -> element(operand, "[" + index + "]", list.get(index));
        case PoseValue pose ->
            element(operand, "[" + index + "]", Value.of(pose.pose().get(index)));
        case MatrixValue matrix -> {
          int row = index / matrix.columns();
          int column = index % matrix.columns();
          double number = matrix.get(row, column);
          yield element(
              operand,
              "[" + row + ", " + column + "]",
              matrix.integers() ? Value.of((int) number) : Value.of(number));
        }
        case StructValue struct -> {
          String name = struct.names().get(index);
          yield new Part(name, operand + "." + name, struct.memberAt(index));
        }
        default -> throw new IllegalArgumentException(value.kind() + " has no parts");
      };
    } catch (ScriptError e) {
      throw new IllegalArgumentException("part " + index + " of " + expression, e);
    }
  }

  private static Part element(String operand, String place, Value value) {
    return new Part(place, operand + place, value);
  }
}
