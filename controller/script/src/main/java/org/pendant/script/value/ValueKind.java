package org.pendant.script.value;

/** Value kinds: the fundamental ones (manual 3 to 5). */
public enum ValueKind {
  NONE("none", ""),
  BOOL("bool", "aBool"),
  INT("int", "anInt"),
  FLOAT("float", "aFloat"),
  STRING("string", "aString"),
  POSE("pose", "aPose"),
  LIST("list", "aList"),
  MATRIX("matrix", "aMatrix"),
  STRUCT("struct", "aStruct"),
  HANDLE("handle", "aHandle");

  private final String text;
  private final String article;

  ValueKind(String text, String article) {
    this.text = text;
    this.article = article;
  }

  /** The name for messages. */
  public String text() {
    return text;
  }

  /** The name with its article, e.g. {@code an int}; {@code None} has none. */
  public String described() {
    return this == NONE ? "None" : ValueTexts.text(article);
  }

  public boolean isNumber() {
    return this == INT || this == FLOAT;
  }

  /** Whether a variable of this kind may take a value of {@code other}: int and float are one. */
  public boolean accepts(ValueKind other) {
    return this == other || (isNumber() && other.isNumber());
  }
}
