package org.pendant.desktop.shell.run;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.LongFunction;
import org.pendant.controller.message.LogEntry;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;

/** Recent messages: the last few lines of the log. */
final class RecentMessages {
  private static final int MOST = 8;

  private List<LogEntry> last = List.of();
  private Optional<Object> source = Optional.empty();
  private long newest;

  /**
   * Looks for other lines than before.
   *
   * @param whose what keeps the log; lines of another one have nothing to do with those of before
   * @param number of the newest line that is wanted
   * @param since gives the lines after a number, also those after the newest that is wanted
   * @return whether there are other lines
   */
  boolean take(Object whose, long number, LongFunction<List<LogEntry>> since) {
    if (number == newest && source.filter(whose::equals).isPresent()) {
      return false;
    }
    source = Optional.of(whose);
    newest = number;
    last =
        since.apply(Math.max(0, number - MOST)).stream()
            .filter(entry -> entry.number() <= number)
            .toList();
    return true;
  }

  /** They as text, newest last; the first line of each. */
  List<Message> messages() {
    return last.stream().map(RecentMessages::message).toList();
  }

  private static Message message(LogEntry entry) {
    String written = ByteText.decoded(entry.text());
    String text = entry.origin() == LogEntry.Origin.SCRIPT ? written : Messages.shown(written);
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
