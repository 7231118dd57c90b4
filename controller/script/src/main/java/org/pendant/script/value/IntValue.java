package org.pendant.script.value;

/** A 32-bit signed integer. */
public record IntValue(int value) implements Value {
  @Override
  public ValueKind kind() {
    return ValueKind.INT;
  }
}
