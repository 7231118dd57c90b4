package org.pendant.script.value;

/** None: the value of a function that returns nothing, and of {@code None}. */
public enum NoneValue implements Value {
  NONE;

  @Override
  public ValueKind kind() {
    return ValueKind.NONE;
  }
}
