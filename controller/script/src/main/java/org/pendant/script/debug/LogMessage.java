package org.pendant.script.debug;

import java.util.ArrayList;
import java.util.List;

/**
 * Log message: what a breakpoint that stops nothing writes: a text with expressions in braces, such
 * as {@code turn {i}: {get_actual_tcp_pose()}}. A brace without its partner is text.
 *
 * @param parts in their order
 */
public record LogMessage(List<Part> parts) {

  /** The parts are copied. */
  public LogMessage {
    parts = List.copyOf(parts);
  }

  /**
   * A part of it.
   *
   * @param from where it begins in the whole text, behind the brace of an expression
   * @param text as it is, or an expression
   */
  public record Part(int from, String text, boolean expression) {}

  /** Takes a text apart. */
  public static LogMessage of(String text) {
    List<Part> parts = new ArrayList<>();
    int start = 0;
    int open = text.indexOf('{');
    while (open >= 0) {
      int close = close(text, open);
      if (close < 0) {
        break;
      }
      if (!text.substring(open + 1, close).isBlank()) {
        if (open > start) {
          parts.add(new Part(start, text.substring(start, open), false));
        }
        parts.add(new Part(open + 1, text.substring(open + 1, close), true));
        start = close + 1;
      }
      open = text.indexOf('{', close + 1);
    }
    if (start < text.length()) {
      parts.add(new Part(start, text.substring(start), false));
    }
    return new LogMessage(parts);
  }

  /** The brace that closes one; those in strings do not count. */
  private static int close(String text, int open) {
    boolean string = false;
    for (int i = open + 1; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '"') {
        string = !string;
      } else if (c == '}' && !string) {
        return i;
      }
    }
    return -1;
  }

  /** The expressions in it, in their order. */
  public List<Part> expressions() {
    return parts.stream().filter(Part::expression).toList();
  }
}
