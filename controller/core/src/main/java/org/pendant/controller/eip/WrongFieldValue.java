package org.pendant.controller.eip;

/**
 * Field value that does not fit into its part of an assembly; the message continues after its
 * label.
 */
final class WrongFieldValue extends Exception {
  private static final long serialVersionUID = 1L;

  private final String code;

  private WrongFieldValue(String code, String message) {
    super(message);
    this.code = code;
  }

  static WrongFieldValue outOfRange(String found, String expected) {
    return new WrongFieldValue("value-out-of-range", "is " + found + ", must be " + expected);
  }

  static WrongFieldValue wrongType(String found, String expected) {
    return new WrongFieldValue("wrong-type", "is " + found + ", must be " + expected);
  }

  String code() {
    return code;
  }
}
