package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.List;
import java.util.Locale;

/**
 * Input change: what an input is from some time on.
 *
 * @param timeS since the start of the program, 0 to {@link #MAX_TIME_S}
 * @param signal its name as {@link SignalText#input} takes it
 * @param value such as {@code true}, {@code 12} or {@code 7.5V}
 */
public record InputChange(double timeS, String signal, String value) {
  /** Latest time of a change, s: a week. */
  public static final double MAX_TIME_S = 604_800;

  /**
   * Checks all three.
   *
   * @throws IllegalArgumentException if there is no such input, or it does not take the value
   */
  public InputChange {
    checkTime("timeOfChange", timeS);
    SignalText.input(signal, value);
  }

  /**
   * Refuses what is no time since the start of a program.
   *
   * @param what key of the text that refuses it
   */
  static void checkTime(String what, double timeS) {
    if (!(timeS >= 0 && timeS <= MAX_TIME_S)) {
      throw new IllegalArgumentException(
          text(what, timeS, String.format(Locale.ROOT, "%.0f", MAX_TIME_S)));
    }
  }

  /** What it changes. */
  List<SignalWrite> writes() {
    return SignalText.input(signal, value);
  }
}
