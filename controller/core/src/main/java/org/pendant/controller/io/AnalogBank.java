package org.pendant.controller.io;

/** A pair of analog signals that stand beside each other on the control box or the tool. */
public enum AnalogBank {
  STANDARD_IN("analog_in"),
  STANDARD_OUT("analog_out"),
  TOOL_IN("tool_analog_in");

  /** Signals of each bank; they count from 0. */
  public static final int SIZE = 2;

  private final String text;

  AnalogBank(String text) {
    this.text = text;
  }

  /** The name outside of scripts, as in {@code analog_in[0]}. */
  public String text() {
    return text;
  }

  /** The name of one signal outside of scripts, such as {@code analog_in[0]}. */
  public String name(int index) {
    return text + "[" + index + "]";
  }

  /** Whether the world outside sets the signals. */
  public boolean input() {
    return this != STANDARD_OUT;
  }

  /**
   * Checks the number of a signal.
   *
   * @throws IllegalArgumentException if there is no such signal
   */
  void check(int index) {
    if (index < 0 || index >= SIZE) {
      throw new IllegalArgumentException(SignalTexts.text("index", text, index, SIZE - 1));
    }
  }
}
