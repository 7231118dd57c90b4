package org.pendant.desktop.shell.run;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.function.LongFunction;
import org.pendant.controller.message.LogEntry;
import org.pendant.language.source.ByteText;

/** Recent messages: the last few lines of the log. */
final class RecentMessages {
  private static final int MOST = 8;

  private final Deque<LogEntry> last = new ArrayDeque<>();
  private long newest;

  /**
   * Looks for new lines.
   *
   * @param number of the newest line that there is
   * @param since gives the lines after a number
   * @return whether there is anything new
   */
  boolean take(long number, LongFunction<List<LogEntry>> since) {
    if (number == newest) {
      return false;
    }
    if (number < newest) {
      // Another controller.
      last.clear();
      newest = 0;
    }
    since.apply(Math.max(newest, number - MOST)).forEach(last::addLast);
    while (last.size() > MOST) {
      last.removeFirst();
    }
    newest = number;
    return true;
  }

  /** They as text, newest last; the first line of each. */
  List<Message> messages() {
    return last.stream().map(RecentMessages::message).toList();
  }

  private static Message message(LogEntry entry) {
    String text = ByteText.decoded(entry.text());
    return new Message(
        String.format(Locale.ROOT, "%.3f", entry.timeS()),
        entry.level(),
        text.lines().findFirst().orElse(""),
        text);
  }

  /**
   * A line of the log.
   *
   * @param time robot time, s
   * @param line its first line
   * @param whole all of it
   */
  record Message(String time, LogEntry.Level level, String line, String whole) {}
}
