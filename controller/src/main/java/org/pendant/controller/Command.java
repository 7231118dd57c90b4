package org.pendant.controller;

import org.pendant.controller.machine.Program;

/** What somebody outside asks of a controller; carried out at the begin of the next frame. */
public sealed interface Command {

  /** Starts a program; refused while another one runs or is paused. */
  record StartProgram(Program program) implements Command {}

  /** Ends the program; the arm comes to rest on its path. */
  record StopProgram() implements Command {}

  /** Holds script time; the arm comes to rest on its path. */
  record PauseProgram() implements Command {}

  /** Goes on after a pause; a popup that caused it closes. */
  record ResumeProgram() implements Command {}

  /** Runs a secondary program beside the primary one, to its end (manual 12). */
  record RunSecondary(Program program) implements Command {}

  /**
   * Sets a digital input.
   *
   * @param name such as {@code digital_in[0]}, {@code configurable_in[3]} or {@code tool_in[1]}
   */
  record SetInput(String name, boolean level) implements Command {}

  /**
   * Moves the speed slider.
   *
   * @param fraction 0 to 1
   */
  record SetSpeedFraction(double fraction) implements Command {}

  /** Closes a popup; a program that it paused goes on. */
  record AnswerPopup(long number) implements Command {}

  /**
   * Hands a line of statements to interpreter mode (manual 13).
   *
   * @param line bytes, one {@code char} a byte, without the line end
   */
  record Interpret(String line) implements Command {}

  /** Drops the interpreted lines that have not begun (manual 13.6). */
  record SkipInterpreted() implements Command {}

  /** Ends the move that the main thread waits for early (manual 13.5). */
  record AbortMove() implements Command {}
}
