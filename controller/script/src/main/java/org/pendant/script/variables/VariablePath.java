package org.pendant.script.variables;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Variable path: a variable, or an element or member of one: {@code count}, {@code p[2]}, {@code
 * part.size}.
 *
 * @param name of the variable
 * @param steps from its value to the part that is meant; an element of a matrix takes two
 */
public record VariablePath(String name, List<Selector> steps) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");
  private static final Pattern STEP =
      Pattern.compile("\\s*(?:\\.\\s*(\\w+)|\\[\\s*(\\d+)\\s*(?:,\\s*(\\d+)\\s*)?])");

  /** More digits than this are no index of any list. */
  private static final int MAX_DIGITS = 9;

  public VariablePath {
    steps = List.copyOf(steps);
  }

  /** Into one part of a value. */
  public sealed interface Selector {
    /** Element {@code index}, from 0. */
    record Element(int index) implements Selector {}

    /** The member called {@code name}. */
    record Member(String name) implements Selector {}
  }

  /**
   * Reads one; spaces do not count, and {@code m[0, 1]} is {@code m[0][1]}.
   *
   * @throws IllegalArgumentException if it is anything else, with the text
   */
  public static VariablePath of(String text) {
    String wanted = text.strip();
    Matcher name = NAME.matcher(wanted);
    if (!name.lookingAt()) {
      throw refused(text);
    }
    List<Selector> steps = new ArrayList<>();
    Matcher step = STEP.matcher(wanted);
    int at = name.end();
    while (at < wanted.length()) {
      step.region(at, wanted.length());
      if (!step.lookingAt()) {
        throw refused(text);
      }
      if (step.group(1) != null) {
        steps.add(new Selector.Member(step.group(1)));
      } else {
        steps.add(new Selector.Element(index(step.group(2), text)));
        if (step.group(3) != null) {
          steps.add(new Selector.Element(index(step.group(3), text)));
        }
      }
      at = step.end();
    }
    return new VariablePath(name.group(), steps);
  }

  /** Whether {@link #of} would take {@code text}. */
  public static boolean isOne(String text) {
    try {
      return of(text).name().length() > 0;
    } catch (IllegalArgumentException e) {
      // that is the answer
      return false;
    }
  }

  private static int index(String digits, String text) {
    if (digits.length() > MAX_DIGITS) {
      throw refused(text);
    }
    return Integer.parseInt(digits);
  }

  private static IllegalArgumentException refused(String text) {
    return new IllegalArgumentException(TracedVariableTexts.text("noVariable", text.strip()));
  }

  /** The one way to write it, without spaces and commas: {@code part.sizes[2]}. */
  public String text() {
    StringBuilder text = new StringBuilder(name);
    for (Selector step : steps) {
      switch (step) {
        case Selector.Element element -> text.append('[').append(element.index()).append(']');
        case Selector.Member member -> text.append('.').append(member.name());
      }
    }
    return text.toString();
  }
}
