package org.pendant.script.value;

import static org.pendant.script.value.ValueTexts.text;

import org.pendant.models.pose.Pose;

/**
 * Element and member access: elements by index and members by name, see {@link Operators#index}.
 */
final class Access {
  private Access() {}

  static Value get(Value receiver, Value index) throws ScriptError {
    int place = place(index);
    // not a pattern switch: it takes much longer
    if (receiver instanceof PoseValue pose) {
      return Value.of(pose.pose().get(component(place)));
    }
    if (receiver instanceof StructValue struct) {
      return struct.get(place);
    }
    if (receiver instanceof MatrixValue matrix) {
      return matrix.row(place);
    }
    if (receiver instanceof ListValue list) {
      return list.get(place);
    }
    throw notIndexed(receiver);
  }

  static Value open(Value receiver, Value index) throws ScriptError {
    return switch (receiver) {
      case ListValue list -> list.open(place(index));
      case StructValue struct -> struct.open(place(index));
      default -> get(receiver, index);
    };
  }

  static Value get(Value receiver, Value row, Value column) throws ScriptError {
    MatrixValue matrix = matrix(receiver);
    double number = matrix.get(place(row), place(column));
    return matrix.integers() ? Value.of((int) number) : Value.of(number);
  }

  static Value set(Value receiver, Value index, Value element) throws ScriptError {
    int place = place(index);
    switch (receiver) {
      case ListValue list -> list.set(place, element);
      case StructValue struct -> struct.set(place, element);
      case PoseValue pose -> {
        return with(pose.pose(), component(place), element);
      }
      case MatrixValue matrix ->
          throw new ScriptError("wrong-type", text("oneIndexForMatrix", place));
      default -> throw notIndexed(receiver);
    }
    return receiver;
  }

  static Value set(Value receiver, Value row, Value column, Value element) throws ScriptError {
    MatrixValue matrix = matrix(receiver);
    if (!element.kind().isNumber()) {
      throw elementNotNumber("matrix", element);
    }
    matrix.set(
        place(row), place(column), Operators.number(element), element.kind() == ValueKind.INT);
    return receiver;
  }

  static StructValue struct(Value receiver, String name) throws ScriptError {
    if (receiver instanceof StructValue struct) {
      return struct;
    }
    throw new ScriptError("wrong-type", text("noStruct", name, Operators.described(receiver)));
  }

  private static PoseValue with(Pose pose, int component, Value element) throws ScriptError {
    if (!element.kind().isNumber()) {
      throw elementNotNumber("pose", element);
    }
    return new PoseValue(pose.with(component, Operators.number(element)));
  }

  private static ScriptError elementNotNumber(String receiver, Value element) {
    return new ScriptError(
        "wrong-type", text("elementNoNumber", receiver, Operators.described(element)));
  }

  private static MatrixValue matrix(Value receiver) throws ScriptError {
    if (receiver instanceof MatrixValue matrix) {
      return matrix;
    }
    throw new ScriptError("wrong-type", text("noMatrix", Operators.described(receiver)));
  }

  /** An int, or a float without fraction. */
  private static int place(Value index) throws ScriptError {
    if (index instanceof IntValue i) {
      return i.value();
    }
    if (index instanceof FloatValue f && f.value() == (int) f.value()) {
      return (int) f.value();
    }
    throw new ScriptError(
        "wrong-type",
        text(
            "indexNoInt", index instanceof FloatValue ? index.text() : Operators.described(index)));
  }

  private static int component(int place) throws ScriptError {
    ListChecks.index(place, Pose.SIZE);
    return place;
  }

  private static ScriptError notIndexed(Value receiver) {
    return new ScriptError("wrong-type", text("noElements", Operators.described(receiver)));
  }
}
