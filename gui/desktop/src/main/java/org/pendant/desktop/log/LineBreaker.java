package org.pendant.desktop.log;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToIntFunction;

/** Line breaker: breaks a text into lines that fit a width, at blanks where there are any. */
final class LineBreaker {
  /** More lines than a user reads in a table; the whole text is below it. */
  static final int MAX_LINES = 100;

  /** No line on any screen has more characters; to measure more would take long. */
  private static final int MAX_CHARACTERS = 1000;

  private LineBreaker() {}

  /**
   * The lines, at least one.
   *
   * @param widths how wide a text is drawn
   * @param width that no line exceeds, unless it is a single character
   * @param most lines; the last says so where there would be more
   */
  static List<String> lines(String text, ToIntFunction<String> widths, int width, int most) {
    List<String> lines = new ArrayList<>();
    for (String each : text.split("\n", -1)) {
      wrap(each.stripTrailing().replace("\t", "  "), widths, width, most, lines);
      if (lines.size() >= most) {
        List<String> first = new ArrayList<>(lines.subList(0, most - 1));
        first.add("\u2026");
        return first;
      }
    }
    return lines;
  }

  private static void wrap(
      String text, ToIntFunction<String> widths, int width, int most, List<String> lines) {
    String rest = text;
    while (lines.size() < most && tooLong(rest, widths, width)) {
      int fits = fitting(rest, widths, width);
      int blank = rest.lastIndexOf(' ', fits);
      int end = blank > 0 ? blank : fits;
      lines.add(rest.substring(0, end));
      rest = rest.substring(end).stripLeading();
    }
    lines.add(rest);
  }

  private static boolean tooLong(String text, ToIntFunction<String> widths, int width) {
    return text.length() > MAX_CHARACTERS || (text.length() > 1 && widths.applyAsInt(text) > width);
  }

  /** How many characters fit, at least one. */
  private static int fitting(String text, ToIntFunction<String> widths, int width) {
    int low = 1;
    int high = Math.min(text.length(), MAX_CHARACTERS);
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (widths.applyAsInt(text.substring(0, middle)) <= width) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
}
