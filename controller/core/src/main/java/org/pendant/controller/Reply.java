package org.pendant.controller;

import org.pendant.script.vm.Interpreter;
import org.pendant.script.vm.InterpreterStatus;

/** The answer to a {@link Command}, given at the end of the frame that carried it out. */
public sealed interface Reply {

  /** Carried out. */
  record Done() implements Reply {}

  /**
   * Not carried out; who asked is the only one that is told.
   *
   * @param reason what, the value, what was expected
   */
  record Refused(String reason) implements Reply {}

  /**
   * Carried out, and ended by an error of the program, which stands in the log already: a secondary
   * program.
   *
   * @param reason what, the value, what was expected
   */
  record Failed(String reason) implements Reply {}

  /** What interpreter mode is at. */
  record InterpreterState(InterpreterStatus status) implements Reply {}

  /** What interpreter mode says to a line. */
  record Interpreted(Interpreter.Response reply) implements Reply {}
}
