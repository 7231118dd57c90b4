package org.pendant.controller.io;

/** Register direction: who writes a register: clients an input, programs an output. */
public enum RegisterDirection {
  INPUT("input"),
  OUTPUT("output");

  private final String text;

  RegisterDirection(String text) {
    this.text = text;
  }

  /** The word that scripts use, as in {@code read_input_float_register}. */
  public String text() {
    return text;
  }

  /** The name of a register outside of scripts, such as {@code input_float_register[3]}. */
  public String name(RegisterKind kind, int address) {
    return text + "_" + kind.text() + "_register[" + address + "]";
  }
}
