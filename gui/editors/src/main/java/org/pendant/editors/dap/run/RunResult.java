package org.pendant.editors.dap.run;

import java.util.Optional;
import org.pendant.script.vm.ScriptFailure;

/**
 * Run result: how a program came to its end.
 *
 * @param exitCode the one that {@code pendant run} has for it
 * @param failure the error that ended it
 * @param reason what else ended it
 * @param line where, from 1; 0 for nowhere
 */
public record RunResult(
    int exitCode, Optional<ScriptFailure> failure, Optional<String> reason, int line) {
  /** All of it ran, or it was told to end. */
  public static final int DONE = 0;

  /** A runtime error or a safety stop ended it. */
  public static final int PROGRAM_FAILED = 1;

  /** A fault in Pendant ended it. */
  public static final int INTERNAL_ERROR = 70;
}
