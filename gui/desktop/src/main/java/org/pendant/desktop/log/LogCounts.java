package org.pendant.desktop.log;

import java.util.Locale;

/**
 * Log counts: what the bar says about the messages.
 *
 * @param messages how many there are, and what is not here
 * @param matches where the search stands; empty without one
 */
record LogCounts(String messages, String matches) {

  static LogCounts of(LogPresenter presenter, int selectedRow) {
    return new LogCounts(messages(presenter), matches(presenter, selectedRow));
  }

  private static String messages(LogPresenter presenter) {
    StringBuilder text = new StringBuilder();
    if (presenter.rows() < presenter.kept()) {
      text.append(number(presenter.rows())).append(" of ");
    }
    text.append(number(presenter.kept())).append(presenter.kept() == 1 ? " message" : " messages");
    if (presenter.dropped() > 0) {
      text.append(", ").append(number(presenter.dropped())).append(" older ones dropped");
    }
    if (presenter.missed() > 0) {
      text.append(", ").append(number(presenter.missed())).append(" missed");
    }
    return text.toString();
  }

  private static String matches(LogPresenter presenter, int selectedRow) {
    if (presenter.search().empty()) {
      return "";
    }
    if (presenter.matchCount() == 0) {
      return "none found";
    }
    int number = presenter.matchNumber(selectedRow);
    return (number == 0 ? "" : number(number) + " of ") + number(presenter.matchCount());
  }

  private static String number(long value) {
    return String.format(Locale.ROOT, "%,d", value);
  }
}
