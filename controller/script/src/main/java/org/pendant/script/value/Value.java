package org.pendant.script.value;

/**
 * Script value. Lists, matrices and structs are mutable and owned by the one variable that holds
 * them: code that stores one elsewhere stores a {@link #copy()} (manual 4.2.1, 7: everything is
 * passed by value). All others are immutable.
 */
public sealed interface Value
    permits NoneValue,
        BoolValue,
        IntValue,
        FloatValue,
        StringValue,
        PoseValue,
        ListValue,
        MatrixValue,
        StructValue,
        HandleValue {

  ValueKind kind();

  /** An independent value with the same content; immutable values answer themselves. */
  default Value copy() {
    return this;
  }

  /**
   * What it counts towards the memory of its program, in bytes: with all its parts, and as if
   * copies shared nothing.
   */
  default long sizeBytes() {
    return Long.BYTES;
  }

  /** The text that {@code to_str} and {@code textmsg} make of it (manual 16.57, 16.65). */
  default String text() {
    return ValueText.of(this);
  }

  static Value of(boolean value) {
    return value ? BoolValue.TRUE : BoolValue.FALSE;
  }

  static Value of(int value) {
    return new IntValue(value);
  }

  static Value of(double value) {
    return new FloatValue(value);
  }

  static Value of(String bytes) {
    return new StringValue(bytes);
  }
}
