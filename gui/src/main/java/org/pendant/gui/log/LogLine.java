package org.pendant.gui.log;

import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.language.source.ByteText;

/**
 * A message as people read it.
 *
 * @param number what the controller calls it, from 1
 * @param timeS controller time, s
 * @param text may have several lines
 */
record LogLine(long number, double timeS, Level level, Origin origin, String text) {
  private static final Pattern PLACE = Pattern.compile("\\bline (\\d{1,9})\\b");

  static LogLine of(LogEntry entry) {
    return new LogLine(
        entry.number(),
        entry.timeS(),
        entry.level(),
        entry.origin(),
        ByteText.decoded(entry.text()).stripTrailing());
  }

  /** The first line of the text; a mark at its end says that there are more. */
  String firstLine() {
    int end = text.indexOf('\n');
    return end < 0 ? text : text.substring(0, end).stripTrailing() + " \u2026";
  }

  /** The 1-based line of the program that the message is about; what programs write has none. */
  OptionalInt sourceLine() {
    if (origin == Origin.SCRIPT) {
      return OptionalInt.empty();
    }
    Matcher place = PLACE.matcher(text);
    if (!place.find() || Integer.parseInt(place.group(1)) == 0) {
      return OptionalInt.empty();
    }
    return OptionalInt.of(Integer.parseInt(place.group(1)));
  }

  /** What people call the severity. */
  String severity() {
    return switch (level) {
      case INFO -> "Info";
      case WARNING -> "Warning";
      case ERROR -> "Error";
    };
  }

  /** What people call the part that wrote it. */
  String source() {
    return sourceOf(origin);
  }

  static String sourceOf(Origin origin) {
    return switch (origin) {
      case SCRIPT -> "Script";
      case CONTROLLER -> "Controller";
      case ENDING -> "Program end";
    };
  }
}
