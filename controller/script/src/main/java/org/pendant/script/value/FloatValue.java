package org.pendant.script.value;

/** A 64-bit floating point number. */
public record FloatValue(double value) implements Value {
  @Override
  public ValueKind kind() {
    return ValueKind.FLOAT;
  }
}
