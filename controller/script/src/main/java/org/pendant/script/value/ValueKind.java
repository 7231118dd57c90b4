package org.pendant.script.value;

/** Value kinds: the fundamental ones (manual 3 to 5). */
public enum ValueKind {
  NONE("none"),
  BOOL("bool"),
  INT("int"),
  FLOAT("float"),
  STRING("string"),
  POSE("pose"),
  LIST("list"),
  MATRIX("matrix"),
  STRUCT("struct"),
  HANDLE("handle");

  private final String text;

  ValueKind(String text) {
    this.text = text;
  }

  /** The name for messages. */
  public String text() {
    return text;
  }

  /** The name with its article, e.g. {@code an int}; {@code None} has none. */
  public String described() {
    return switch (this) {
      case NONE -> "None";
      case INT -> "an int";
      default -> "a " + text;
    };
  }

  public boolean isNumber() {
    return this == INT || this == FLOAT;
  }

  /** Whether a variable of this kind may take a value of {@code other}: int and float are one. */
  public boolean accepts(ValueKind other) {
    return this == other || (isNumber() && other.isNumber());
  }
}
