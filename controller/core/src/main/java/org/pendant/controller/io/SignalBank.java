package org.pendant.controller.io;

import java.util.Arrays;
import java.util.List;
import org.pendant.controller.wire.SignalGroup;

/**
 * Signal bank: a group of digital signals that stand beside each other on the control box or the
 * tool.
 */
public enum SignalBank {
  STANDARD_IN("digital_in", 8),
  STANDARD_OUT("digital_out", 8),
  CONFIGURABLE_IN("configurable_in", 8),
  CONFIGURABLE_OUT("configurable_out", 8),
  TOOL_IN("tool_in", 2),
  TOOL_OUT("tool_out", 2),
  /** Internal bits that programs share; they outlive a program (manual 18.9). */
  FLAG("flag", 32);

  private final String text;
  private final int size;

  SignalBank(String text, int size) {
    this.text = text;
    this.size = size;
  }

  /** The name outside of scripts, as in {@code digital_in[0]}. */
  public String text() {
    return text;
  }

  /**
   * The bank of that name.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static SignalBank named(String text) {
    return Arrays.stream(values())
        .filter(bank -> bank.text.equals(text))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("no signals are called " + text));
  }

  /** All of them, for the files of cells. */
  public static List<SignalGroup> groups() {
    return Arrays.stream(values())
        .map(bank -> new SignalGroup(bank.text, 0, bank.size, bank.input(), SignalGroup.LEVEL))
        .toList();
  }

  /** Number of signals; they count from 0. */
  public int size() {
    return size;
  }

  /** Whether the world outside sets the signals. */
  public boolean input() {
    return this == STANDARD_IN || this == CONFIGURABLE_IN || this == TOOL_IN;
  }

  /**
   * Checks the number of a signal.
   *
   * @throws IllegalArgumentException if there is no such signal
   */
  void check(int index) {
    if (index < 0 || index >= size) {
      throw new IllegalArgumentException(SignalTexts.text("index", text, index, size - 1));
    }
  }
}
