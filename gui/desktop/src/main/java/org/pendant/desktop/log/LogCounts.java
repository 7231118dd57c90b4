package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.kit.text.Messages;
import org.pendant.text.Language;

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
    List<String> parts = new ArrayList<>();
    String kept =
        text(presenter.kept() == 1 ? "oneMessage" : "messageCount", number(presenter.kept()));
    parts.add(
        presenter.rows() < presenter.kept() ? text("of", number(presenter.rows()), kept) : kept);
    if (presenter.dropped() > 0) {
      parts.add(text("olderOnesDropped", number(presenter.dropped())));
    }
    if (presenter.missed() > 0) {
      parts.add(text("missed", number(presenter.missed())));
    }
    return Messages.joined(parts);
  }

  private static String matches(LogPresenter presenter, int selectedRow) {
    if (presenter.search().empty()) {
      return "";
    }
    if (presenter.matchCount() == 0) {
      return text("noneFound");
    }
    int number = presenter.matchNumber(selectedRow);
    String all = number(presenter.matchCount());
    return number == 0 ? all : text("of", number(number), all);
  }

  private static String number(long value) {
    return Language.ofProcess().grouped(value);
  }
}
