package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Reply;

final class ProgramOriginTest {
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final ProgramOrigin origin = new ProgramOrigin();

  private CompletableFuture<Reply> start() {
    CompletableFuture<Reply> reply =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, "sleep(1)\n")));
    controller.advance();
    return reply;
  }

  @Test
  void aFrameThatIsFasterThanWhoAsksShowsTheOwnProgram() throws Exception {
    CompletableFuture<Thread> frame = new CompletableFuture<>();
    var _ =
        origin.expect(
            () -> {
              CompletableFuture<Reply> reply = start();
              Thread loop = Thread.ofPlatform().start(() -> origin.frame(controller.state()));
              while (loop.getState() != Thread.State.WAITING && loop.isAlive()) {
                Thread.onSpinWait();
              }
              frame.complete(loop);
              return reply;
            });
    frame.join().join();
    assertFalse(origin.strangerLast());
  }

  @Test
  void aProgramThatNobodyHereHasAskedForIsOfOthers() {
    var _ = start();
    origin.frame(controller.state());
    assertTrue(origin.strangerLast());
  }
}
