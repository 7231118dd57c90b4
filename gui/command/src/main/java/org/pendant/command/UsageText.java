package org.pendant.command;

import java.util.ArrayList;
import java.util.List;

/** A usage text under construction. */
final class UsageText {
  private static final int LEFT_COLUMNS = 32;

  private final List<String> lines = new ArrayList<>();

  void add(String line) {
    lines.add(line);
  }

  /** A term and its explanation, side by side or below each other. */
  void row(String term, String explanation) {
    if (term.length() > LEFT_COLUMNS - 2) {
      lines.add("  " + term);
      lines.add(" ".repeat(LEFT_COLUMNS + 2) + explanation);
    } else {
      lines.add("  " + term + " ".repeat(LEFT_COLUMNS - term.length()) + explanation);
    }
  }

  List<String> all() {
    return List.copyOf(lines);
  }
}
