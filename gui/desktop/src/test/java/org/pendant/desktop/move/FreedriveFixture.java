package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;

/** A controller, and what has been sent to it. */
final class FreedriveFixture {
  /** How many frames pass between two refreshes of a screen. */
  static final int FRAMES_A_REFRESH = 17;

  final List<Command> sent = new ArrayList<>();
  private final Controller controller = new Controller(ControllerOptions.headless());

  CompletableFuture<Reply> submit(Command command) {
    sent.add(command);
    return controller.submit(command);
  }

  /** Has something done at once. */
  void done(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    frames(1);
    assertEquals(new Reply.Done(), reply.join());
  }

  ControllerState state() {
    return controller.state();
  }

  void frames(int count) {
    controller.runUntil(() -> false, count);
  }

  /** Has a program wait for ever after this line. */
  void run(String line) {
    String text = "def p():\n  " + line + "\n  sleep(1000)\nend\n";
    done(new ProgramCommand.StartProgram(TestController.program(controller, text)));
    frames(2);
  }
}
