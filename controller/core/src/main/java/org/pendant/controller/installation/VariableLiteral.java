package org.pendant.controller.installation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import org.pendant.language.source.ByteText;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.HandleValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/**
 * Variable literals: values as literals of the language, so that a later program begins with them.
 */
public final class VariableLiteral {
  /** Longest text that is kept, in characters; what is longer is no setting but data. */
  public static final int LONGEST = 20_000;

  private VariableLiteral() {}

  /**
   * The literal that gives this very value again; empty where the language has none, such as for
   * handles, numbers that are not finite, and texts with a quote or a line end, and where it would
   * be longer than {@value #LONGEST} characters.
   */
  public static Optional<String> of(Value value) {
    return literal(value).filter(text -> text.length() <= LONGEST);
  }

  private static Optional<String> literal(Value value) {
    return switch (value) {
      case BoolValue bool -> Optional.of(bool(bool.value()));
      case IntValue number -> whole(number.value());
      case FloatValue number -> decimal(number.value());
      case StringValue text -> text(text);
      case PoseValue pose -> pose(pose.pose());
      case ListValue list -> list(list);
      case MatrixValue matrix -> matrix(matrix);
      case StructValue struct -> struct(struct);
      case HandleValue _ -> Optional.empty();
      case NoneValue _ -> Optional.empty();
    };
  }

  private static String bool(boolean value) {
    return value ? "True" : "False";
  }

  private static Optional<String> whole(double value) {
    // the smallest one is written as a minus before a number that is too large
    return value == Integer.MIN_VALUE
        ? Optional.empty()
        : Optional.of(Integer.toString((int) value));
  }

  private static Optional<String> decimal(double value) {
    return Double.isFinite(value) ? Optional.of(Double.toString(value)) : Optional.empty();
  }

  private static Optional<String> text(StringValue value) {
    if (value.length() > LONGEST) {
      return Optional.empty();
    }
    String bytes = value.bytes();
    String decoded = ByteText.decoded(bytes);
    boolean plain = bytes.chars().noneMatch(c -> c == '"' || c == '\r' || c == '\n');
    return plain && ByteText.asBytes(decoded).equals(bytes)
        ? Optional.of('"' + decoded + '"')
        : Optional.empty();
  }

  private static Optional<String> pose(Pose pose) {
    return joined("p[", Pose.SIZE, i -> decimal(pose.get(i)));
  }

  private static Optional<String> list(ListValue list) {
    return switch (list) {
      case NumberList numbers ->
          joined("[", list.length(), i -> number(numbers.numberAt(i), numbers.elementKind()));
      case ObjectList objects -> joined("[", list.length(), i -> literal(objects.objectAt(i)));
    };
  }

  private static Optional<String> number(double value, ValueKind kind) {
    return switch (kind) {
      case BOOL -> Optional.of(bool(value != 0));
      case INT -> whole(value);
      case FLOAT -> decimal(value);
      case NONE, STRING, POSE, LIST, MATRIX, STRUCT, HANDLE -> Optional.empty();
    };
  }

  private static Optional<String> matrix(MatrixValue matrix) {
    ValueKind kind = matrix.integers() ? ValueKind.INT : ValueKind.FLOAT;
    return joined(
        "[",
        matrix.rows(),
        row -> joined("[", matrix.columns(), column -> number(matrix.numberAt(row, column), kind)));
  }

  private static Optional<String> struct(StructValue struct) {
    List<String> members = new ArrayList<>();
    for (int i = 0; i < struct.length(); i++) {
      Optional<String> member = literal(struct.memberAt(i));
      if (member.isEmpty()) {
        return Optional.empty();
      }
      members.add(struct.names().get(i) + "=" + member.get());
    }
    return Optional.of("struct(" + String.join(", ", members) + ")");
  }

  /** Elements in brackets, if there is a literal for each, and as long as they are short enough. */
  private static Optional<String> joined(
      String begin, int count, IntFunction<Optional<String>> element) {
    StringBuilder out = new StringBuilder(begin);
    for (int i = 0; i < count; i++) {
      Optional<String> next = element.apply(i);
      if (next.isEmpty() || out.length() > LONGEST) {
        return Optional.empty();
      }
      out.append(i == 0 ? "" : ", ").append(next.get());
    }
    return Optional.of(out.append(']').toString());
  }
}
