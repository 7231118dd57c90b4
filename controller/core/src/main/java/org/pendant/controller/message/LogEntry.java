package org.pendant.controller.message;

import java.util.Optional;
import org.pendant.script.function.ScriptPlace;

/**
 * Log entry: one line of the log.
 *
 * @param number counts from 1, without gaps
 * @param timeS controller time, s
 * @param code of the error, such as {@code C153A2} of a safety function or {@code wrong-type} of
 *     what ended a program; empty where there is none
 * @param text its bytes, one {@code char} (0 to 255) a byte
 * @param place what the program was at; empty when none ran, and where that says nothing
 */
public record LogEntry(
    long number,
    double timeS,
    Level level,
    Origin origin,
    String code,
    String text,
    Optional<ScriptPlace> place) {

  /** A line without code and place. */
  public LogEntry(long number, double timeS, Level level, Origin origin, String text) {
    this(number, timeS, level, origin, "", text, Optional.empty());
  }

  /**
   * This entry with a text of at most {@code bytes}; where some is missing, its end says how long
   * it was.
   *
   * @param bytes at least 64
   */
  public LogEntry shortened(int bytes) {
    return text.length() <= bytes
        ? this
        : new LogEntry(number, timeS, level, origin, code, shortened(text, bytes), place);
  }

  /** A text of at most {@code bytes}, at least 64, as {@link #shortened(int)} makes it. */
  public static String shortened(String text, int bytes) {
    if (text.length() <= bytes) {
      return text;
    }
    int noteLength = MessageTexts.text("cut", "", text.length()).length();
    return MessageTexts.text("cut", text.substring(0, bytes - noteLength), text.length());
  }

  /** How bad it is. */
  public enum Level {
    INFO,
    WARNING,
    ERROR
  }

  /** Who wrote it. */
  public enum Origin {
    /** A program, with {@code textmsg}. */
    SCRIPT,
    CONTROLLER,
    /** The safety functions: stops, warnings, changes of mode. */
    SAFETY,
    /** Something outside that speaks to the controller by a protocol. */
    PROTOCOL,
    /** The controller, about what ended a program; the same stands in the program's ending. */
    ENDING
  }
}
