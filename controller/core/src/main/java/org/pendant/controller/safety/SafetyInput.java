package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** Safety inputs: signals that demand a safety function. */
public enum SafetyInput {
  /** The emergency stop button of the robot. */
  EMERGENCY_STOP,
  /** The emergency stop of the machines around it. */
  SYSTEM_EMERGENCY_STOP,
  /** A person is near: the arm waits. The program continues by itself when the signal is gone. */
  SAFEGUARD_STOP,
  /** As {@link #SAFEGUARD_STOP}, unless manual mode is chosen. */
  AUTOMATIC_MODE_SAFEGUARD_STOP,
  /** The reduced limits hold. */
  REDUCED_MODE;

  private final String word = name().toLowerCase(Locale.ROOT);

  /** The name as people type it, such as {@code safeguard_stop}. */
  public String word() {
    return word;
  }

  /**
   * The input called {@code word}.
   *
   * @throws IllegalArgumentException if there is none; the message names those there are
   */
  public static SafetyInput named(String word) {
    for (SafetyInput each : values()) {
      if (each.word.equals(word)) {
        return each;
      }
    }
    throw new IllegalArgumentException(
        text(
            "unknownInput",
            word,
            Arrays.stream(values()).map(SafetyInput::word).collect(Collectors.joining(", "))));
  }
}
