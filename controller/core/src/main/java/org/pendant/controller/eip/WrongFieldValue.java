package org.pendant.controller.eip;

import static org.pendant.controller.eip.AssemblyDataTexts.text;

/** Field value that does not fit into its part of an assembly. */
final class WrongFieldValue extends Exception {
  private static final long serialVersionUID = 1L;

  private final String code;

  private final String found;
  private final String expected;

  private WrongFieldValue(String code, String found, String expected) {
    super(expected);
    this.code = code;
    this.found = found;
    this.expected = expected;
  }

  static WrongFieldValue outOfRange(String found, String expected) {
    return new WrongFieldValue("value-out-of-range", found, expected);
  }

  static WrongFieldValue wrongType(String found, String expected) {
    return new WrongFieldValue("wrong-type", found, expected);
  }

  String code() {
    return code;
  }

  /** What is wrong with the part of that label. */
  String of(String label) {
    return text("wrongValue", label, found, expected);
  }
}
