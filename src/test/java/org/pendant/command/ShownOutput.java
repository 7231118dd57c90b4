package org.pendant.command;

import java.util.ArrayList;
import java.util.List;

/**
 * Shown output: what a page says that a command prints. A line {@code ...} stands for any lines,
 * three points within a line for any text.
 */
final class ShownOutput {
  private static final String ANYTHING = "...";

  private ShownOutput() {}

  /** Whether {@code printed} is what {@code shown} says. */
  static boolean agrees(List<String> shown, List<String> printed) {
    if (shown.isEmpty()) {
      return printed.isEmpty();
    }
    List<String> rest = shown.subList(1, shown.size());
    if (shown.getFirst().strip().equals(ANYTHING)) {
      for (int from = 0; from <= printed.size(); from++) {
        if (agrees(rest, printed.subList(from, printed.size()))) {
          return true;
        }
      }
      return false;
    }
    return !printed.isEmpty()
        && lineAgrees(shown.getFirst(), printed.getFirst())
        && agrees(rest, printed.subList(1, printed.size()));
  }

  private static boolean lineAgrees(String shown, String printed) {
    List<String> parts = new ArrayList<>(List.of(shown.stripTrailing().split("\\.\\.\\.", -1)));
    String line = printed.stripTrailing();
    String first = parts.removeFirst();
    if (parts.isEmpty()) {
      return line.equals(first);
    }
    String last = parts.removeLast();
    if (!line.startsWith(first)
        || !line.endsWith(last)
        || line.length() < first.length() + last.length()) {
      return false;
    }
    int at = first.length();
    for (String part : parts) {
      int found = line.indexOf(part, at);
      if (found < 0 || found + part.length() > line.length() - last.length()) {
        return false;
      }
      at = found + part.length();
    }
    return true;
  }
}
