package org.pendant.recording;

/**
 * Recording mark: something worth a mark on a timeline.
 *
 * @param frame in which it happened
 * @param timeS end of that frame, robot time, s
 * @param text name of a program, why it failed, text of a label, message of a stop
 * @param line 1-based line that the program had reached, 0 when none ran
 */
public record RecordingMark(Kind kind, long frame, double timeS, String text, int line) {
  /** What happened. */
  public enum Kind {
    PROGRAM_STARTED,
    /** It finished, halted or was stopped. */
    PROGRAM_ENDED,
    PROGRAM_FAILED,
    /** The program has come to another label of its text (manual 11). */
    LABEL,
    PROTECTIVE_STOP,
    /** An emergency stop, a safeguard stop, a violation or a fault. */
    SAFETY_STOP,
    /** A popup or a question. */
    MESSAGE,
    /** A log line of level ERROR that does not tell of a stop or an ended program. */
    ERROR
  }
}
