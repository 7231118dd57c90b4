package org.pendant.controller;

import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Reply;
import org.pendant.script.vm.InterpretedLine;
import org.pendant.script.vm.Interpreter;

/** Handler of the commands to interpreter mode. */
final class InterpreterCommandHandler implements CommandHandler<InterpreterCommand> {
  private final Interpreter interpreter;

  InterpreterCommandHandler(Interpreter interpreter) {
    this.interpreter = interpreter;
  }

  @Override
  public Class<InterpreterCommand> family() {
    return InterpreterCommand.class;
  }

  @Override
  public Reply carryOut(InterpreterCommand command) {
    return switch (command) {
      case InterpreterCommand.Interpret(InterpretedLine line) ->
          new Reply.Interpreted(interpreter.submit(line));
      case InterpreterCommand.SkipInterpreted _ -> {
        interpreter.skip();
        yield Reply.done();
      }
      case InterpreterCommand.AskInterpreter _ -> new Reply.InterpreterState(interpreter.status());
    };
  }
}
