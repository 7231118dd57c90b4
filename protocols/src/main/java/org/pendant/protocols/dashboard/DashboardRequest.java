package org.pendant.protocols.dashboard;

import java.util.Locale;
import java.util.Optional;

/**
 * Dashboard request: one line that a client has sent.
 *
 * @param argument what follows the words, without blanks around it; may be empty
 */
record DashboardRequest(DashboardCommand word, String argument) {

  /** Reads a line; empty when it is none of what can be asked. Capitals count in arguments only. */
  static Optional<DashboardRequest> read(String line) {
    for (DashboardCommand word : DashboardCommand.values()) {
      Optional<String> rest = after(word, line);
      if (rest.isPresent() && (word.takesArgument() || rest.get().isEmpty())) {
        return Optional.of(new DashboardRequest(word, rest.get()));
      }
    }
    return Optional.empty();
  }

  /** What follows the words at the start of {@code line}. */
  private static Optional<String> after(DashboardCommand word, String line) {
    String rest = line.strip();
    for (String each : word.words()) {
      int end = blank(rest);
      if (!rest.substring(0, end).toLowerCase(Locale.ROOT).equals(each)) {
        return Optional.empty();
      }
      rest = rest.substring(end).stripLeading();
    }
    return Optional.of(rest);
  }

  private static int blank(String text) {
    int end = 0;
    while (end < text.length() && !Character.isWhitespace(text.charAt(end))) {
      end++;
    }
    return end;
  }
}
