package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.LogEntry;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ScriptFailure;

/** What a program meets that Java calls an error ends the program, and nothing else. */
final class ErrorsInProgramsTest {
  private Controller controller;

  /** Runs a program that meets {@code error} in its second line. */
  private ScriptFailure failing(Error error) {
    Builtins<ControlBox> builtins = StandardBuiltins.create();
    builtins
        .declare("meet_error")
        .manual("test", "1")
        .doc("Throws.")
        .does(
            call -> {
              throw error;
            });
    controller = new Controller(ControllerOptions.headless(), builtins);
    TestController.start(controller, "def meets():\n  meet_error()\nend\n");
    controller.runUntil(this::stopped, 10);
    Ending ending = controller.state().program().ending().orElseThrow();
    return assertInstanceOf(Ending.Failed.class, ending).failure();
  }

  private boolean stopped() {
    return controller.state().program().state() == ProgramState.STOPPED;
  }

  private List<String> log() {
    return controller.logSince(0).stream().map(LogEntry::text).toList();
  }

  @Test
  void aProgramThatUsesUpTheMemoryOfJavaEndsForThatReason() {
    ScriptFailure failure = failing(new OutOfMemoryError("Java heap space"));
    assertEquals("out-of-memory", failure.code());
    assertEquals(2, failure.line());
    assertEquals(
        List.of("program meets, line 2: out of memory: the program has used up Java's memory"),
        log());
  }

  @Test
  void anyOtherErrorIsAnInternalOne() {
    assertEquals("internal-error", failing(new StackOverflowError()).code());
    assertTrue(log().getFirst().startsWith("internal error: java.lang.StackOverflowError"));
    assertEquals("internal-error", failing(new LinkageError("translated")).code());
  }

  @Test
  void theControllerRunsTheNextProgram() {
    failing(new OutOfMemoryError("Java heap space"));
    TestController.start(controller, "def well():\n  textmsg(\"well\")\nend\n");
    controller.runUntil(this::stopped, 10);
    assertEquals("well", log().getLast());
    assertInstanceOf(Ending.Finished.class, controller.state().program().ending().orElseThrow());
  }

  @Test
  void aSecondaryProgramThatMeetsOneLeavesThePrimaryOne() {
    failing(new OutOfMemoryError("Java heap space"));
    TestController.start(controller, "def goes_on():\n  sleep(9)\nend\n");
    var reply =
        controller.submit(
            new ProgramCommand.RunSecondary(
                TestController.program(controller, "sec s():\n  meet_error()\nend\n")));
    controller.advance();
    assertInstanceOf(Reply.Failed.class, reply.join());
    assertEquals(ProgramState.RUNNING, controller.state().program().state());
  }
}
