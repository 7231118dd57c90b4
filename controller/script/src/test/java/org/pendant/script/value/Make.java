package org.pendant.script.value;

import java.util.Arrays;
import java.util.List;
import org.pendant.models.pose.Pose;

/** Short names for values in tests. */
public final class Make {
  private Make() {}

  public static Value value(Object plain) {
    return switch (plain) {
      case Value value -> value;
      case Integer i -> Value.of((int) i);
      case Double d -> Value.of((double) d);
      case Boolean b -> Value.of((boolean) b);
      case String s -> Value.of(s);
      default -> throw new IllegalArgumentException("no value: " + plain);
    };
  }

  public static NumberList ints(int... elements) {
    return NumberList.ofInts(elements);
  }

  public static NumberList floats(double... elements) {
    return NumberList.of(elements);
  }

  public static NumberList bools(boolean... elements) {
    return NumberList.ofBools(elements);
  }

  /** What the literal {@code [elements]} gives. */
  public static Value list(Object... elements) throws ScriptError {
    return Operators.listLiteral(Arrays.stream(elements).map(Make::value).toArray(Value[]::new));
  }

  public static ListValue strings(String... elements) {
    Value[] values = Arrays.stream(elements).map(Value::of).toArray(Value[]::new);
    return ObjectList.owning(values, values.length, Value.of(""));
  }

  /** An empty list with room. */
  public static NumberList room(int capacity) {
    return NumberList.owning(new double[capacity], 0, Kind.INT);
  }

  public static MatrixValue matrix(NumberList... rows) throws ScriptError {
    return (MatrixValue) Operators.listLiteral(rows);
  }

  public static PoseValue pose(double... components) {
    return new PoseValue(Pose.of(components));
  }

  public static StructValue struct(String name, Object member) {
    return StructValue.owning(List.of(name), value(member));
  }

  public static StructValue struct(String a, Object first, String b, Object second) {
    return StructValue.owning(List.of(a, b), value(first), value(second));
  }
}
