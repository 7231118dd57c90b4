package org.pendant.controller.safety;

import java.util.OptionalInt;

/**
 * Safety stop: why the arm was stopped.
 *
 * @param mode the safety mode while the stop lasts
 * @param category how the arm is stopped
 * @param code of the error, the x of CxAy
 * @param argument of the error, the y of CxAy
 * @param joint the joint that it is about, 0 to 5, if it is about one
 * @param timeS controller time of the frame in which it happened, s
 * @param value what was found; 0 where nothing was measured
 * @param limit what would have been right at most (or at least, for a lower limit); 0 where nothing
 *     was measured
 * @param unit of value and limit; empty where nothing was measured
 * @param message all of it as a sentence
 */
public record SafetyStop(
    SafetyMode mode,
    StopCategory category,
    int code,
    int argument,
    OptionalInt joint,
    double timeS,
    double value,
    double limit,
    String unit,
    String message) {

  /** What happened, without code, time and what was measured. */
  public String sentence() {
    String sentence = message.substring(message.indexOf(": ") + 2);
    return unit.isEmpty() ? sentence : sentence.substring(0, sentence.lastIndexOf(": "));
  }

  /** Whether it is about where the arm should go, and not about where it is. */
  public boolean aboutTarget() {
    return switch (code) {
      case 150, 151, 152, 154, 200, 204 -> true;
      default -> false;
    };
  }

  /** Code and argument as the log shows them, such as {@code C153A2}. */
  public String codeText() {
    return "C" + code + "A" + argument;
  }
}
