package org.pendant.desktop.log;

import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.SentenceUnits;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.script.function.ScriptPlace;

/**
 * Log line: a message as people read it.
 *
 * @param number what the mailbox calls it, from 1
 * @param timeS controller time, s
 * @param wall when it arrived here
 * @param code such as {@code C153A2}; empty for none
 * @param text may have several lines
 * @param place what a program was at; empty for none
 * @param controller the one of a cell that it is of; empty where there is one alone
 */
record LogLine(
    long number,
    double timeS,
    Instant wall,
    Level level,
    LogSource source,
    String code,
    String text,
    Optional<ScriptPlace> place,
    String controller) {
  /** The name of the text that interpreter mode is fed with: no line of a file. */
  private static final String INTERPRETER = "interpreter";

  /** For messages without a known time of arrival: those of a recording. */
  static final Instant NO_WALL = Instant.MIN;

  private static final DateTimeFormatter CLOCK =
      DateTimeFormatter.ofPattern("HH:mm:ss.SSS", Locale.ROOT).withZone(ZoneId.systemDefault());

  static LogLine of(long number, Instant wall, LogSource source, LogEntry entry) {
    return of(number, wall, source, entry, "");
  }

  /** As the other one, of a controller of a cell, by whose name the text begins. */
  static LogLine of(
      long number, Instant wall, LogSource source, LogEntry entry, String controller) {
    return new LogLine(
        number,
        entry.timeS(),
        wall,
        entry.level(),
        source,
        entry.code(),
        (controller.isEmpty() ? "" : controller + ": ") + words(entry).stripTrailing(),
        entry.place(),
        controller);
  }

  /** What safety says with numbers in the units that people have chosen; all others as they are. */
  LogLine in(PoseForm form) {
    return source == LogSource.SAFETY
        ? new LogLine(
            number,
            timeS,
            wall,
            level,
            source,
            code,
            SentenceUnits.in(text, form),
            place,
            controller)
        : this;
  }

  /**
   * What programs and clients wrote stays; what the controller says is in the window's language.
   */
  private static String words(LogEntry entry) {
    String text = ByteText.decoded(entry.text());
    return entry.origin() == LogEntry.Origin.SCRIPT ? text : Messages.shown(text);
  }

  /** The first line of the text; a mark at its end says that there are more. */
  String firstLine() {
    int end = text.indexOf('\n');
    return end < 0 ? text : text.substring(0, end).stripTrailing() + " \u2026";
  }

  /** The text without the code at its start, for where that stands beside it. */
  String withoutCode() {
    String before = controller.isEmpty() ? "" : controller + ": ";
    return !shortCode().isEmpty() && text.startsWith(before + code + " ")
        ? before + text.substring(before.length() + code.length() + 1)
        : text;
  }

  /** The code where it is one of the short ones of the safety functions; empty for others. */
  String shortCode() {
    return source == LogSource.SAFETY ? code : "";
  }

  /** The 1-based line of the program that leads to where the message comes from, if one does. */
  OptionalInt sourceLine() {
    return place.isPresent() && !place.get().source().equals(INTERPRETER)
        ? OptionalInt.of(place.get().line())
        : OptionalInt.empty();
  }

  /** The thread of the program; empty for none. */
  String thread() {
    return place
        .map(at -> at.thread() == 0 ? "main" : ByteText.decoded(at.threadName()))
        .orElse("");
  }

  /** The line as it is shown, also that of interpreter mode; empty for none. */
  String lineText() {
    return place.map(at -> Integer.toString(at.line())).orElse("");
  }

  /** Robot time, s. */
  String timeText() {
    return String.format(Locale.ROOT, "%.3f", timeS);
  }

  /** Time of day when it arrived; empty if that is not known. */
  String wallText() {
    return wall.equals(NO_WALL) ? "" : CLOCK.format(wall);
  }

  /** When it arrived, by ISO 8601; empty if that is not known. */
  String isoText() {
    return wall.equals(NO_WALL) ? "" : wall.toString();
  }

  /** What people call the severity. */
  String severity() {
    return switch (level) {
      case INFO -> LogTexts.text("info");
      case WARNING -> LogTexts.text("warning");
      case ERROR -> LogTexts.text("error");
    };
  }
}
