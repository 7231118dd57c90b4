package org.pendant.script.vm;

/**
 * Interpreter event: what happens to the lines of interpreter mode, for its log files (manual
 * 13.8).
 */
public sealed interface InterpreterEvent {
  /** About what it takes in memory. */
  default int bytes() {
    return switch (this) {
      case Accepted accepted -> accepted.text().length();
      case ProgramStarted started -> started.program().length();
      case Cleared cleared -> 0;
      case Kept kept -> 0;
    };
  }

  /** A program has started: ids begin again. */
  record ProgramStarted(String program) implements InterpreterEvent {}

  /**
   * A line was accepted.
   *
   * @param id of the line
   * @param executed id of the newest line whose execution had begun, 0 for none
   * @param text its bytes, one {@code char} each
   */
  record Accepted(int id, int executed, String text) implements InterpreterEvent {}

  /** What was interpreted has been cleared, at the end of interpreter mode or before. */
  record Cleared() implements InterpreterEvent {}

  /** Interpreter mode has ended, and what was interpreted stays in the program. */
  record Kept() implements InterpreterEvent {}
}
