package org.pendant.script.value;

/** Boolean value: {@code True} or {@code False}. */
public record BoolValue(boolean value) implements Value {
  static final BoolValue TRUE = new BoolValue(true);
  static final BoolValue FALSE = new BoolValue(false);

  @Override
  public ValueKind kind() {
    return ValueKind.BOOL;
  }
}
