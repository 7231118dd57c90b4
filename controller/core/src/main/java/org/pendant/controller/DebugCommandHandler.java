package org.pendant.controller;

import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Reply;
import org.pendant.script.debug.Debugger;
import org.pendant.script.variables.VariableTracer;

/** Handler of what is asked of the debugger and the variable tracer. */
final class DebugCommandHandler implements CommandHandler<DebugCommand> {
  private final Debugger debugger;
  private final VariableTracer tracer;

  DebugCommandHandler(Debugger debugger, VariableTracer tracer) {
    this.debugger = debugger;
    this.tracer = tracer;
  }

  @Override
  public Class<DebugCommand> family() {
    return DebugCommand.class;
  }

  @Override
  public Reply carryOut(DebugCommand command) {
    switch (command) {
      case DebugCommand.Debug debug -> debug.request().accept(debugger);
      case DebugCommand.TraceVariables trace -> tracer.trace(trace.owner(), trace.paths());
    }
    return Reply.done();
  }
}
