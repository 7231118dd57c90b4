package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.script.debug.Breakpoint;

/** What clients may have done in a single frame, and what they are told beyond that. */
final class CrowdedFrameTest {
  private static final String SECONDARY = "sec s():\n  textmsg(\"beside\")\nend\n";

  private final Controller controller = new Controller(ControllerOptions.headless());

  private CompletableFuture<Reply> submit(Command command) {
    return controller.submit(command);
  }

  private CompletableFuture<Reply> submitSecondary() {
    return submit(new ProgramCommand.RunSecondary(TestController.program(controller, SECONDARY)));
  }

  @Test
  void theNinthSecondaryProgramOfAFrameIsRefused() {
    List<CompletableFuture<Reply>> replies = new ArrayList<>();
    for (int i = 0; i < 9; i++) {
      replies.add(submitSecondary());
    }
    controller.advance();
    assertEquals(
        new Reply.Refused(Refusal.Code.LIMIT, "more than 8 secondary programs in a frame"),
        replies.getLast().join());
    assertEquals(8, replies.stream().filter(each -> each.join() instanceof Reply.Done).count());
  }

  @Test
  void aSecondaryProgramIsRefusedAtOnceWhileADebuggerHoldsTheFrame() {
    var _ = submit(new DebugCommand.Debug(debugger -> debugger.set(Breakpoint.at(2))));
    TestController.start(controller, "def p():\n  x = 1\n  sleep(9)\nend\n");
    assertTrue(controller.state().debug().held());
    CompletableFuture<Reply> reply = submitSecondary();
    controller.advance();
    assertEquals(
        new Reply.Refused(Refusal.Code.DEBUGGER, "a debugger has paused program p"), reply.join());
    var _ = submit(new DebugCommand.Debug(debugger -> debugger.resume()));
    controller.advance();
    assertEquals(List.of(), controller.logSince(0));
  }

  @Test
  void linesBeyondTheSixteenthWaitForTheNextFrame() {
    TestController.start(controller, "def p():\n  interpreter_mode()\nend\n");
    List<CompletableFuture<Reply>> replies = new ArrayList<>();
    for (int i = 0; i < 20; i++) {
      replies.add(submit(new InterpreterCommand.Interpret("textmsg(" + i + ")")));
    }
    controller.advance();
    assertEquals(16, replies.stream().filter(CompletableFuture::isDone).count());
    controller.advance();
    for (CompletableFuture<Reply> reply : replies) {
      assertInstanceOf(Reply.Interpreted.class, reply.join());
    }
  }
}
