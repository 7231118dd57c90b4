package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.vm.ProgramState;

/** What commands do while robot time stands: all that they do, and no time passes. */
final class StandingTimeTest {
  private static final Deadline SOON = Deadline.orNever(Duration.ofMinutes(1));

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final SteerableClock clock = new SteerableClock(new Pace.Paused());
  private final List<String> popups = new CopyOnWriteArrayList<>();
  private final FrameLoop loop = FrameLoop.start(controller, clock, this::see);

  @AfterEach
  void stop() {
    loop.close();
  }

  private void see() {
    controller.state().newPopups().forEach(each -> popups.add(each.text()));
  }

  private Reply ask(Command command) {
    return controller.ask(command, SOON);
  }

  @Test
  void commandsAreCarriedOutAndNoTimePasses() {
    long frame = controller.state().frame();
    assertEquals(Reply.done(), ask(new MessageCommand.ShowPopup("Popup", "look here")));
    assertEquals(Reply.done(), ask(new MessageCommand.WriteLog(LogEntry.Level.INFO, "a line")));
    // by the reply to the next command the frame loop has seen the snapshot of the one before
    assertEquals(List.of("look here"), popups);
    assertEquals("a line", controller.logSince(0).getLast().text());
    assertEquals(Reply.done(), ask(new IoCommand.SetInput("digital_in[3]", true)));
    assertEquals(8, controller.state().io().standardIn());
    assertEquals(Reply.done(), ask(new SafetyCommand.PowerOff()));
    assertEquals(frame, controller.state().frame());
    assertEquals(0, controller.state().timeS());
  }

  @Test
  void secondaryProgramsRunOrAreRefusedAtOnce() {
    assertEquals(
        Reply.done(),
        ask(
            new ProgramCommand.RunSecondary(
                TestController.program(
                    controller, "sec s():\n  set_digital_out(0, True)\nend\n"))));
    assertEquals(1, controller.state().io().standardOut());
    assertEquals(Reply.done(), ask(new BoxCommand.ShutDown()));
    Reply.Refused refused =
        assertInstanceOf(
            Reply.Refused.class,
            ask(
                new ProgramCommand.RunSecondary(
                    TestController.program(
                        controller, "sec s():\n  set_digital_out(1, True)\nend\n"))));
    assertEquals(Refusal.Code.SWITCHED_OFF, refused.refusal().code());
    assertEquals(1, controller.state().io().standardOut());
    assertEquals(0, controller.state().frame());
  }

  @Test
  void aProgramStartsAndWaitsForTime() {
    assertEquals(
        Reply.done(),
        ask(
            new ProgramCommand.StartProgram(
                TestController.program(controller, "textmsg(\"runs\")\n"))));
    assertEquals(ProgramState.RUNNING, controller.state().program().state());
    assertEquals(List.of(), controller.logSince(0));
    clock.grant(1);
    while (controller.state().frame() == 0) {
      Thread.onSpinWait();
    }
    assertEquals("runs", controller.logSince(0).getFirst().text());
  }

  @Test
  void aFrameThatADebuggerHoldsGoesOnInTheSameFrame() {
    assertEquals(
        Reply.done(), ask(new DebugCommand.Debug(debugger -> debugger.set(Breakpoint.at(2)))));
    assertEquals(
        Reply.done(),
        ask(
            new ProgramCommand.StartProgram(
                TestController.program(controller, "def p():\n  x = 1\n  sleep(9)\nend\n"))));
    clock.grant(1);
    while (!controller.state().debug().held()) {
      Thread.onSpinWait();
    }
    long frame = controller.state().frame();
    assertEquals(Reply.done(), ask(new DebugCommand.Debug(debugger -> debugger.resume())));
    assertFalse(controller.state().debug().held());
    assertEquals(frame, controller.state().frame());
  }
}
