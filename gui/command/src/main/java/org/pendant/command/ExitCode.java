package org.pendant.command;

import java.util.Arrays;
import java.util.Optional;

/** Exit code: what the process answers to the shell; scripts and CI rely on these numbers. */
enum ExitCode {
  /** Everything asked for was done. */
  DONE(0),
  /** The program stopped on a runtime error or a protective stop. */
  PROGRAM_FAILED(1),
  /** A test is red. */
  TESTS_FAILED(1),
  /** A difference is larger than a limit allows. */
  LIMIT_EXCEEDED(1),
  /** The command line is wrong, or a file that it names cannot be read or written. */
  WRONG_USAGE(2),
  /** The program does not compile. */
  DOES_NOT_COMPILE(3),
  /** The program was stopped because its time was up. */
  TIMED_OUT(4),
  /**
   * This machine lacks something that is needed, such as OpenGL; the number that sysexits.h gives
   * to what is unavailable. No fault of the program or the command line.
   */
  UNAVAILABLE(69),
  /** A fault in Pendant itself; the number that sysexits.h gives to software errors. */
  INTERNAL_ERROR(70),
  /** Standard output cannot be written any more; the number of a process that SIGPIPE ended. */
  OUTPUT_CLOSED(141);

  private final int number;

  ExitCode(int number) {
    this.number = number;
  }

  int number() {
    return number;
  }

  /** The first with a number: what another process of Pendant has answered. */
  static Optional<ExitCode> of(int number) {
    return Arrays.stream(values()).filter(each -> each.number == number).findFirst();
  }

  /** This one, unless it is {@link #DONE}: of several results the first that is not counts. */
  ExitCode or(ExitCode later) {
    return this == DONE ? later : this;
  }
}
