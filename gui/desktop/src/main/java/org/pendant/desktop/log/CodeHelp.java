package org.pendant.desktop.log;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.desktop.session.StopAdvice;

/**
 * Code help: what a code of the safety functions means, and what may help; docs/safety.md has the
 * same table.
 *
 * @param meaning a sentence
 * @param suggestion a sentence
 */
record CodeHelp(String meaning, String suggestion) {
  private static final Pattern CODE = Pattern.compile("C(\\d{1,4})A(\\d{1,4})");

  /** Help for a code such as {@code C153A2}; empty for others. */
  static Optional<CodeHelp> of(String code) {
    Matcher parts = CODE.matcher(code);
    if (!parts.matches()) {
      return Optional.empty();
    }
    int number = Integer.parseInt(parts.group(1));
    return meaning(number, Integer.parseInt(parts.group(2)))
        .map(meaning -> new CodeHelp(meaning, StopAdvice.of(number)));
  }

  private static Optional<String> meaning(int code, int argument) {
    return switch (code) {
      case 100 -> Optional.of("An input demands an emergency stop or a safeguard stop.");
      case 150 -> Optional.of("The target of a joint could hardly stop any more before its limit.");
      case 151 ->
          Optional.of("The target could hardly stop any more before the largest tilt of the tool.");
      case 152 -> Optional.of("The target could hardly stop any more before a safety plane.");
      case 153 ->
          Optional.of(
              "A joint was away from its target for 20 ms, or in force mode the TCP from its"
                  + " path.");
      case 154 ->
          Optional.of("The path led through a singularity, or to where the arm is stretched.");
      case 155 ->
          Optional.of("Freedrive found another payload on the flange than the declared one.");
      case 157 ->
          Optional.of(
              "A joint was pushed from outside for 10 ms, or a link hit something in the scene.");
      case 173 -> Optional.of("Warning only: a joint is away from its target.");
      case 191 -> Optional.of("A safety limit was exceeded: " + limit(argument) + ".");
      case 192 -> Optional.of("A joint reports no number, so the safety functions cannot work.");
      case 200 -> Optional.of("No joint positions reach a point of the path.");
      case 204 ->
          Optional.of(argument == 3 ? "The target speed jumps." : "The target position jumps.");
      case 209 -> Optional.of("The program called protective_stop().");
      default -> Optional.empty();
    };
  }

  private static String limit(int argument) {
    return switch (argument) {
      case 0 -> "joint position";
      case 1 -> "joint speed";
      case 2 -> "tool speed";
      case 3 -> "elbow speed";
      case 4 -> "momentum";
      case 5 -> "power";
      case 6 -> "tool force";
      case 7 -> "elbow force";
      case 8 -> "a safety plane";
      case 9 -> "direction of the tool";
      default -> "one that is not known here";
    };
  }
}
