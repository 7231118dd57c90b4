package org.pendant.sweep.run;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** Run outcome: how a run of a sweep ended. */
public enum RunOutcome {
  /** The program ran past its last statement. */
  FINISHED,
  /** The program executed {@code halt}. */
  HALTED,
  /** A runtime error ended the program. */
  FAILED,
  /** A safety function, or something in the way, stopped the arm. */
  STOPPED,
  /** The program still ran when the time limit of the plan was over. */
  NEVER_ENDED,
  /** The program of this variant does not compile. */
  DOES_NOT_COMPILE,
  /** The values of this variant cannot be set up, or the program cannot start. */
  REFUSED,
  /** A fault in Pendant itself. */
  INTERNAL_ERROR;

  /** As tables write it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** The outcome of a word. */
  public static Optional<RunOutcome> of(String word) {
    return Arrays.stream(values()).filter(each -> each.word().equals(word)).findFirst();
  }

  /** Whether the program came to an end of its own. */
  public boolean ended() {
    return this == FINISHED || this == HALTED;
  }
}
