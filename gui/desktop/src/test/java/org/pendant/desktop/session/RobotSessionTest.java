package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

@Timeout(60)
final class RobotSessionTest {
  private static Program program(RobotSession session, String text) {
    return TestController.program(session.robot(), text);
  }

  private static Reply ask(CompletableFuture<Reply> asked) throws Exception {
    return asked.get(30, TimeUnit.SECONDS);
  }

  /** The first frame that shows {@code wanted}, waited for without looking at the clock. */
  private static CompletableFuture<ControllerState> frameWith(
      RobotSession session, ProgramState wanted) {
    CompletableFuture<ControllerState> found = new CompletableFuture<>();
    session.addFrameListener(
        state -> {
          if (state.program().state() == wanted) {
            found.complete(state);
          }
        });
    return found;
  }

  @Test
  void aProgramRunsToItsEnd() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.setPace(new Pace.Unlimited());
      assertInstanceOf(Reply.Done.class, ask(session.run(program(session, "sleep(1)\n"))));
      ControllerState end = frameWith(session, ProgramState.STOPPED).get(30, TimeUnit.SECONDS);
      assertInstanceOf(Ending.Finished.class, end.program().ending().orElseThrow());
    }
  }

  @Test
  void programsOfOthersAreToldFromItsOwn() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      ask(session.run(program(session, "sleep(1000)\n")));
      frameWith(session, ProgramState.RUNNING).get(30, TimeUnit.SECONDS);
      assertFalse(session.strangerLast());
      ask(session.stop());
      frameWith(session, ProgramState.STOPPED).get(30, TimeUnit.SECONDS);
      Program other = program(session, "sleep(1000)\n");
      ask(session.robot().submit(new ProgramCommand.StartProgram(other)));
      frameWith(session, ProgramState.RUNNING).get(30, TimeUnit.SECONDS);
      assertTrue(session.strangerLast());
      assertEquals(1, session.strangersStarted());
      ask(session.stop());
      frameWith(session, ProgramState.STOPPED).get(30, TimeUnit.SECONDS);
      ask(session.run(other));
      frameWith(session, ProgramState.RUNNING).get(30, TimeUnit.SECONDS);
      assertFalse(session.strangerLast());
      assertEquals(1, session.strangersStarted());
    }
  }

  @Test
  void whatIsRefusedSaysWhy() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      assertEquals(
          new Reply.Refused(Refusal.Code.PROGRAM, "no program is running"), ask(session.pause()));
      assertEquals(
          new Reply.Refused(Refusal.Code.PROGRAM, "no program is paused"), ask(session.resume()));
    }
  }

  @Test
  void commandsAreCarriedOutWhileTimeIsPaused() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.setPace(new Pace.Paused());
      ask(session.submit(new BoxCommand.SetSpeedFraction(0.5)));
      long frame = session.state().frame();
      ask(session.submit(new BoxCommand.SetSpeedFraction(0.25)));
      assertEquals(0.25, session.state().arm().speedFraction());
      assertEquals(frame, session.state().frame());
    }
  }

  @Test
  void oneFrameCanBeSteppedWhileTimeIsPaused() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.setPace(new Pace.Paused());
      ask(session.submit(new BoxCommand.SetSpeedFraction(0.5)));
      long frame = session.state().frame();
      CompletableFuture<Long> next = new CompletableFuture<>();
      session.addFrameListener(
          state -> {
            if (state.frame() > frame) {
              next.complete(state.frame());
            }
          });
      session.stepFrame();
      assertEquals(frame + 1, next.get(30, TimeUnit.SECONDS));
    }
  }

  @Test
  void anotherRobotKeepsPaceAndListeners() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.setPace(new Pace.Unlimited());
      session.restart(session.options().withRobot("ur20"));
      CompletableFuture<Long> seen = new CompletableFuture<>();
      session.addFrameListener(state -> seen.complete(state.frame()));
      assertTrue(seen.get(30, TimeUnit.SECONDS) > 0);
      assertEquals("ur20", session.options().robotId());
      assertEquals(new Pace.Unlimited(), session.pace());
    }
  }

  @Test
  void anotherRobotKeepsTheSpeedOfPrograms() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      ask(session.submit(new BoxCommand.SetSpeedFraction(0.4)));
      session.restart(session.options().withRobot("ur20"));
      ask(session.stop());
      assertEquals(0.4, session.state().arm().speedFraction());
    }
  }

  @Test
  void aRobotThatIsNotKnownChangesNothing() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      ControllerOptions wrong = session.options().withRobot("ur99");
      assertThrows(IllegalArgumentException.class, () -> session.restart(wrong));
      assertInstanceOf(Reply.Done.class, ask(session.stop()));
    }
  }

  @Test
  void everyCommandGetsAReplyEvenAfterTheEnd() throws Exception {
    RobotSession session = RobotSession.start(ControllerOptions.headless());
    session.setPace(new Pace.Paused());
    session.close();
    assertEquals(
        new Reply.Refused(Refusal.Code.SWITCHED_OFF, "the controller is switched off"),
        ask(session.stop()));
  }
}
