package org.pendant.controller.message;

/**
 * One line of the log.
 *
 * @param number counts from 1, without gaps
 * @param timeS controller time, s
 * @param text its bytes, one {@code char} (0 to 255) a byte
 */
public record LogEntry(long number, double timeS, Level level, Origin origin, String text) {

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
    /** The controller, about what ended a program; the same stands in the program's ending. */
    ENDING
  }
}
