package org.pendant.controller.rule;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.io.Signal;

/**
 * Signal condition of a rule: levels of signals, all of which must be so, such as {@code
 * digital_out[2] is on and tool_in[0] is off}. {@code rises} and {@code falls} are other words for
 * {@code is on} and {@code is off} in a rule that begins when something becomes so.
 *
 * @param levels at least one
 */
public record SignalCondition(List<Level> levels) {
  /** What may follow a signal, for messages. */
  static final String FORM = "signals with rises, falls, is on or is off, joined by and";

  private static final Pattern LEVEL =
      Pattern.compile("(\\w+\\[\\d{1,2}\\])(?: +(rises|falls|is on|is off))?");

  /** Most levels of a condition. */
  private static final int MAX = 16;

  /**
   * A level that a signal must have.
   *
   * @param on whether it must be high
   */
  public record Level(Signal signal, boolean on) {}

  /** The list is copied. */
  public SignalCondition {
    levels = List.copyOf(levels);
  }

  /**
   * Reads a condition.
   *
   * @throws IllegalArgumentException if it is none
   */
  public static SignalCondition of(String text) {
    List<Level> levels = new ArrayList<>();
    for (String part : text.strip().split(" +and +", -1)) {
      Matcher words = LEVEL.matcher(part.strip());
      if (!words.matches()) {
        throw new IllegalArgumentException("is \"" + part.strip() + "\", must be " + FORM);
      }
      String word = words.group(2) == null ? "is on" : words.group(2);
      levels.add(
          new Level(Signal.named(words.group(1)), word.equals("rises") || word.equals("is on")));
    }
    if (levels.size() > MAX) {
      throw new IllegalArgumentException(
          "has " + levels.size() + " signals, must have at most " + MAX);
    }
    return new SignalCondition(levels);
  }

  /** Whether it holds now. */
  boolean holds(DigitalIo io) {
    for (int i = 0; i < levels.size(); i++) {
      Level each = levels.get(i);
      if (io.level(each.signal().bank(), each.signal().index()) != each.on()) {
        return false;
      }
    }
    return true;
  }
}
