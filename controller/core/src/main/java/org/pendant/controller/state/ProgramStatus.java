package org.pendant.controller.state;

import java.util.Optional;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;

/**
 * Program status: what the program is doing.
 *
 * @param runtime what the program and, because of it, the arm do
 * @param name of the running or last program, empty before the first
 * @param line 1-based line that the main thread has reached, 0 when no program runs
 * @param ending how the last program ended; empty while one runs and before the first
 */
public record ProgramStatus(
    ProgramState state, RuntimeState runtime, String name, int line, Optional<Ending> ending) {
  /** Before the first program. */
  public static final ProgramStatus NONE =
      new ProgramStatus(ProgramState.STOPPED, RuntimeState.STOPPED, "", 0, Optional.empty());

  /** Whether it ended by an error. */
  public boolean failed() {
    return ending.isPresent() && ending.get() instanceof Ending.Failed;
  }
}
