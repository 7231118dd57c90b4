package org.pendant.controller.io;

/** The kinds of general-purpose registers. */
public enum RegisterKind {
  BOOLEAN("boolean", 128),
  INTEGER("integer", 48),
  FLOAT("float", 48);

  private final String text;
  private final int size;

  RegisterKind(String text, int size) {
    this.text = text;
    this.size = size;
  }

  /** The word that scripts use, as in {@code read_input_float_register}. */
  public String text() {
    return text;
  }

  /** Number of registers in each direction; they count from 0. */
  public int size() {
    return size;
  }

  /**
   * Checks an address.
   *
   * @throws IllegalArgumentException if there is no such register
   */
  void check(int address) {
    if (address < 0 || address >= size) {
      throw new IllegalArgumentException(
          SignalTexts.text("registerAddress", text, address, size - 1));
    }
  }
}
