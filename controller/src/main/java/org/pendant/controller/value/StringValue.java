package org.pendant.controller.value;

/** A string of bytes; {@code bytes} holds one {@code char} (0 to 255) a byte (manual 3). */
public record StringValue(String bytes) implements Value {
  @Override
  public Kind kind() {
    return Kind.STRING;
  }
}
