package org.pendant.controller;

import java.util.List;
import java.util.function.Consumer;
import org.pendant.controller.command.Command;
import org.pendant.script.debug.Debugger;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableTracer;

/** Command of a client that inspects programs. */
public sealed interface DebugCommand extends Command {

  /**
   * Asks something of the debugger, in the frame loop: sets breakpoints, steps, looks at variables
   * and changes them. Refused with the message when the request throws an {@link
   * IllegalArgumentException}; what it finds out it hands over itself, for instance through a
   * future.
   */
  record Debug(Consumer<Debugger> request) implements DebugCommand {}

  /**
   * Reads chosen variables of programs in every frame from now on, into {@link
   * org.pendant.controller.state.ControllerState#traced}. Refused if that were more than {@link
   * VariableTracer#MOST}, those of other owners included.
   *
   * @param owner who wants them, a name that no other client uses; takes the place of its last wish
   * @param paths what it wants; empty for nothing any more
   */
  record TraceVariables(String owner, List<VariablePath> paths) implements DebugCommand {
    public TraceVariables {
      paths = List.copyOf(paths);
    }
  }
}
