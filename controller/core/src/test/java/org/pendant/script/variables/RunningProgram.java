package org.pendant.script.variables;

import java.util.List;
import java.util.stream.Stream;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.debug.Variable;
import org.pendant.script.vm.ProgramState;

/** A controller whose program a test runs frame by frame. */
final class RunningProgram {
  final Controller controller = new Controller(ControllerOptions.headless());

  RunningProgram start(String... lines) {
    Reply reply =
        ask(
            new ProgramCommand.StartProgram(
                TestController.program(controller, String.join("\n", lines) + "\n")));
    if (!(reply instanceof Reply.Done)) {
      throw new AssertionError(reply);
    }
    return this;
  }

  Reply ask(Command command) {
    var reply = controller.submit(command);
    controller.advance();
    return reply.join();
  }

  Reply trace(String owner, String... paths) {
    return ask(
        new DebugCommand.TraceVariables(owner, Stream.of(paths).map(VariablePath::of).toList()));
  }

  RunningProgram frames(int count) {
    for (int i = 0; i < count; i++) {
      controller.advance();
    }
    return this;
  }

  RunningProgram finish() {
    if (!controller.runUntil(
        () -> controller.state().program().state() == ProgramState.STOPPED, 5000)) {
      throw new AssertionError("still running");
    }
    return this;
  }

  ControllerState state() {
    return controller.state();
  }

  VariableSamples samples() {
    return state().variables();
  }

  /** Each as {@code name = text}. */
  static List<String> texts(List<VariableSample> samples) {
    return samples.stream().map(VariableSample::variable).map(RunningProgram::text).toList();
  }

  private static String text(Variable variable) {
    return variable.name() + " = " + variable.text();
  }

  VariableSample sample(String path) {
    return samples()
        .find(VariablePath.of(path))
        .orElseThrow(() -> new AssertionError(path + " is not in " + texts(samples().globals())));
  }
}
