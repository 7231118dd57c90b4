package org.pendant.controller.rule;

import static org.pendant.controller.rule.RuleTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;
import org.pendant.models.json.Range;

/**
 * Signal condition of a rule: what values signals have, all of them together, such as {@code
 * digital_out[2] is on and plc.register[0] is above 7}. {@code rises} and {@code falls} are other
 * words for {@code is on} and {@code is off} in a rule that begins when something becomes so.
 *
 * @param tests at least one
 */
public record SignalCondition(List<Requirement> tests) {
  private static final Pattern REQUIREMENT =
      Pattern.compile(
          "(\\S+)(?: +(?:(rises|falls|is on|is off)|(is|is not|is above|is below)"
              + " +(-?\\d{1,10})))?");

  /** Most tests of a condition. */
  private static final int MAX = 16;

  /** How a value is compared. */
  enum Comparison {
    EQUAL,
    NOT_EQUAL,
    ABOVE,
    BELOW
  }

  /**
   * What the value of a signal must be.
   *
   * @param number that it is compared with; a signal is on that is not 0
   */
  record Requirement(CellSignal signal, Comparison comparison, int number) {
    boolean holds(int value) {
      return switch (comparison) {
        case EQUAL -> value == number;
        case NOT_EQUAL -> value != number;
        case ABOVE -> value > number;
        case BELOW -> value < number;
      };
    }
  }

  /** The list is copied. */
  public SignalCondition {
    tests = List.copyOf(tests);
  }

  /**
   * Reads a condition.
   *
   * @param signals what signals there are
   * @throws IllegalArgumentException if it is none
   */
  public static SignalCondition of(String text, CellSignalNames signals) {
    List<Requirement> tests = new ArrayList<>();
    for (String part : text.strip().split(" +and +", -1)) {
      tests.add(test(part.strip(), signals));
    }
    if (tests.size() > MAX) {
      throw new IllegalArgumentException(text("signals", tests.size(), MAX));
    }
    return new SignalCondition(tests);
  }

  private static Requirement test(String part, CellSignalNames signals) {
    Matcher words = REQUIREMENT.matcher(part);
    if (!words.matches()) {
      throw new IllegalArgumentException(text("form", part));
    }
    CellSignal signal;
    try {
      signal = signals.signal(words.group(1));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(text("wrongSignal", words.group(1), e.getMessage()), e);
    }
    if (words.group(3) == null) {
      String level = Optional.ofNullable(words.group(2)).orElse("is on");
      boolean on = level.equals("rises") || level.equals("is on");
      return new Requirement(signal, on ? Comparison.NOT_EQUAL : Comparison.EQUAL, 0);
    }
    return new Requirement(
        signal, comparison(words.group(3)), number(words.group(4), signals.group(signal)));
  }

  private static Comparison comparison(String words) {
    return switch (words) {
      case "is not" -> Comparison.NOT_EQUAL;
      case "is above" -> Comparison.ABOVE;
      case "is below" -> Comparison.BELOW;
      default -> Comparison.EQUAL;
    };
  }

  private static int number(String digits, SignalGroup group) {
    Range range = group.range();
    double number = Double.parseDouble(digits);
    if (!range.holds(number)) {
      throw new IllegalArgumentException(
          text(
              "number",
              digits,
              Range.number(range.least()),
              Range.number(range.most()),
              group.name()));
    }
    return (int) number;
  }

  /** The signals of its tests at work, in their order. */
  List<SignalLine> watched(SignalLines signals) {
    return tests.stream().map(each -> signals.line(each.signal())).toList();
  }

  /** Whether it holds now. */
  boolean holds(List<SignalLine> watched) {
    for (int i = 0; i < tests.size(); i++) {
      if (!tests.get(i).holds(watched.get(i).value())) {
        return false;
      }
    }
    return true;
  }
}
