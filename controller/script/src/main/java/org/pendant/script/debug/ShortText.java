package org.pendant.script.debug;

import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueText;

/** Short text of a value, cut off early, so that a list of a million elements costs nothing. */
final class ShortText {
  /** Characters after which nothing more is added. */
  static final int ENOUGH = 200;

  private final StringBuilder text = new StringBuilder();

  private ShortText() {}

  static String of(Value value) {
    if (value instanceof StringValue string) {
      return cut(string.bytes());
    }
    ShortText made = new ShortText();
    made.append(value);
    return made.text.toString();
  }

  private static String cut(String bytes) {
    return bytes.length() <= ENOUGH ? bytes : bytes.substring(0, ENOUGH) + "...";
  }

  private void append(Value value) {
    switch (value) {
      case StringValue string -> text.append('"').append(cut(string.bytes())).append('"');
      case ListValue list -> appendAll('[', list.length(), i -> append(element(list, i)), ']');
      case MatrixValue matrix ->
          appendAll('[', matrix.rows(), row -> append(row(matrix, row)), ']');
      case StructValue struct ->
          appendAll(
              '{',
              struct.length(),
              i -> {
                text.append(struct.names().get(i)).append(" = ");
                append(struct.memberAt(i));
              },
              '}');
      default -> text.append(ValueText.of(value));
    }
  }

  /** Adds one of the parts of a value. */
  private interface Part {
    void append(int index);
  }

  private void appendAll(char open, int count, Part part, char close) {
    text.append(open);
    for (int i = 0; i < count; i++) {
      if (i > 0) {
        text.append(", ");
      }
      if (text.length() >= ENOUGH) {
        text.append("...");
        break;
      }
      part.append(i);
    }
    text.append(close);
  }

  private static Value element(ListValue list, int index) {
    try {
      return list.get(index);
    } catch (ScriptError e) {
      throw new IllegalStateException(e);
    }
  }

  private static Value row(MatrixValue matrix, int row) {
    try {
      return matrix.row(row);
    } catch (ScriptError e) {
      throw new IllegalStateException(e);
    }
  }
}
