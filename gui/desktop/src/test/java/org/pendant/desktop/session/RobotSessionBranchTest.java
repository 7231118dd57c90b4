package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.Pace;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.message.Operator;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.lines.RunProfile;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.script.debug.Debugger;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/** Going back to a frame and on from there, as people at a screen do. */
@Timeout(60)
@Tag("slow")
final class RobotSessionBranchTest {
  private static final ControllerOptions DESKTOP =
      ControllerOptions.headless()
          .withOperator(Operator.present())
          .withSystemTime(() -> Instant.EPOCH);

  private static final String SORTING =
      """
      def sorting():
        left = 0
        right = 0
        while left + right < 200:
          if get_standard_digital_in(0):
            left = left + 1
          else:
            right = right + 1
          end
          sleep(0.02)
        end
        sleep(1000)
      end
      """;

  private static final int MAX_SEEN = 2000;

  /** So many frames that a rerun of them is not over when the next statement runs. */
  private static final long LONG = 100_000;

  private static <T> T wait(CompletableFuture<T> asked) throws Exception {
    return asked.get(30, TimeUnit.SECONDS);
  }

  private static Program program(RobotSession session, String text) {
    return TestController.program(session.robot(), text);
  }

  /** The first snapshot of which {@code wanted} holds, waited for without looking at the clock. */
  private static CompletableFuture<ControllerState> frame(
      RobotSession session, Predicate<ControllerState> wanted) {
    CompletableFuture<ControllerState> found = new CompletableFuture<>();
    session.addFrameListener(
        state -> {
          if (wanted.test(state)) {
            found.complete(state);
          }
        });
    return found;
  }

  /** A program that has run up to about {@code frame}; robot time is paused then. */
  private static List<ControllerState> ran(RobotSession session, String text, long frame)
      throws Exception {
    List<ControllerState> seen = new ArrayList<>();
    CompletableFuture<Void> there = new CompletableFuture<>();
    FrameListener listener =
        state -> {
          if (seen.size() < MAX_SEEN && !there.isDone()) {
            seen.add(state);
          }
          if (state.frame() >= frame) {
            session.setPace(new Pace.Paused());
            there.complete(null);
          }
        };
    wait(session.run(program(session, text)));
    session.addFrameListener(listener);
    session.setPace(new Pace.Unlimited());
    there.get(30, TimeUnit.SECONDS);
    session.removeFrameListener(listener);
    return seen;
  }

  @Test
  void standsPausedWhereTheRunStoodAndGoesOnOtherwise() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP)) {
      List<ControllerState> seen = ran(session, SORTING, 1000);
      Robot old = session.robot();
      List<String> told = new ArrayList<>();
      session.addSwitchListener(
          new SwitchListener() {
            @Override
            public void switchingOff() {
              told.add("off " + session.robot().equals(old));
            }

            @Override
            public void switchedOn() {
              told.add("on " + session.robot().equals(old));
            }
          });
      ControllerState then = seen.get(seen.size() / 2);
      Branching branching = session.branch(then);
      assertEquals(new Branching.Outcome.Branched(then.frame()), wait(branching.outcome()));
      assertEquals(1, branching.progress());
      assertEquals(List.of("off true", "on false"), told);
      assertEquals(then.frame(), session.state().frame());
      assertEquals(then.program(), session.state().program());
      assertEquals(then.arm().actualPositionRad(), session.state().arm().actualPositionRad());
      assertEquals(new Pace.Paused(), session.pace());
      assertEquals(
          then.arm().actualPositionRad(),
          session.recording().at(then.timeS()).arm().actualPositionRad());

      wait(session.submit(new IoCommand.SetInput("digital_in[0]", true)));
      session.setPace(new Pace.Unlimited());
      wait(frame(session, state -> state.frame() >= 4000));
      session.setPace(new Pace.Paused());
      assertTrue(global(session, "left") > 50, "left is " + global(session, "left"));
      assertEquals(200, global(session, "left") + global(session, "right"));
    }
  }

  private static int global(RobotSession session, String name) throws Exception {
    CompletableFuture<String> text = new CompletableFuture<>();
    wait(
        session.submit(
            new DebugCommand.Debug(
                debugger -> {
                  try {
                    text.complete(
                        debugger.evaluate(Debugger.MAIN, Debugger.OUTERMOST, name).text());
                  } catch (ScriptError e) {
                    text.completeExceptionally(e);
                  }
                })));
    return Integer.parseInt(wait(text));
  }

  @Test
  void whatLinesTookUntilThenIsKnownAndGoesOn() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP)) {
      List<ControllerState> seen = ran(session, SORTING, 1000);
      long whole = session.profile().line(10).orElseThrow().frames();
      ControllerState then = seen.get(seen.size() / 2);
      wait(session.branch(then).outcome());

      RunProfile back = session.profile();
      assertEquals(1, back.run());
      long half = back.line(10).orElseThrow().frames();
      assertTrue(0 < half && half < whole, half + " of " + whole);
      session.setPace(new Pace.Unlimited());
      wait(frame(session, state -> state.frame() >= 1000));
      session.setPace(new Pace.Paused());
      RunProfile on = session.profile();
      assertEquals(back.firstFrame(), on.firstFrame());
      assertTrue(on.line(10).orElseThrow().frames() >= whole, on.toString());
    }
  }

  @Test
  void aBranchCanBeBranchedAgain() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP)) {
      ran(session, SORTING, 1000);
      wait(session.branch(500).outcome());
      wait(session.submit(new IoCommand.SetInput("digital_in[0]", true)));
      session.setPace(new Pace.Unlimited());
      ControllerState later = wait(frame(session, state -> state.frame() >= 900));
      Branching second = session.branch(session.recording().atFrame(later.frame()));
      assertInstanceOf(Branching.Outcome.Branched.class, wait(second.outcome()));
      assertEquals(later.program().line(), session.state().program().line());
      assertEquals(later.io(), session.state().io());
    }
  }

  @Test
  void thePresentControllerGoesOnUntilThenAndWhenTheBranchIsCancelled() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP)) {
      ran(session, SORTING, LONG);
      Robot old = session.robot();
      Branching branching = session.branch(LONG);
      branching.cancel();
      assertEquals(new Branching.Outcome.Cancelled(), wait(branching.outcome()));
      assertSame(old, session.robot());
      long frame = session.state().frame();
      CompletableFuture<ControllerState> next = frame(session, state -> state.frame() > frame);
      session.stepFrame();
      wait(next);
    }
  }

  @Test
  void anotherBranchTakesThePlaceOfTheOneOnItsWay() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP)) {
      ran(session, SORTING, LONG);
      Branching first = session.branch(LONG);
      Branching second = session.branch(100);
      assertEquals(new Branching.Outcome.Branched(100), wait(second.outcome()));
      assertEquals(new Branching.Outcome.Cancelled(), wait(first.outcome()));
    }
  }

  @Test
  void aRestartEndsABranchOnItsWay() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP)) {
      ran(session, SORTING, LONG);
      Branching branching = session.branch(LONG);
      session.restart(session.options().withRobot("ur20"));
      assertEquals(new Branching.Outcome.Cancelled(), wait(branching.outcome()));
      assertEquals("ur20", session.options().robotId());
    }
  }

  @Test
  void theEndOfTheSessionEndsIt() throws Exception {
    RobotSession session = RobotSession.start(DESKTOP);
    ran(session, SORTING, LONG);
    Branching branching = session.branch(LONG);
    session.close();
    assertEquals(new Branching.Outcome.Cancelled(), wait(branching.outcome()));
  }

  @Test
  void whatCannotBeRepeatedIsRefusedAtOnce() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP)) {
      ran(session, "def f():\n  textmsg(time(2))\n  sleep(1000)\nend\n", 100);
      Robot old = session.robot();
      RerunRefused refused = assertThrows(RerunRefused.class, () -> session.branch(90));
      assertTrue(refused.getMessage().contains("asked for the date"), refused.getMessage());
      assertEquals(Optional.of(refused.getMessage()), session.branchRefusal(90));
      assertEquals(Optional.empty(), session.branchRefusal(0));
      assertSame(old, session.robot());
    }
  }

  @Test
  void aSnapshotOfAnotherRunIsRefusedInTheEnd() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP);
        RobotSession other = RobotSession.start(DESKTOP.withRobot("ur10e"))) {
      ran(session, SORTING, 200);
      ControllerState strange = ran(other, "movej([0, -1, -1, 0, 0, 0])\n", 200).getLast();
      Robot old = session.robot();
      session.setPace(new Pace.Unlimited());
      wait(frame(session, state -> state.frame() > strange.frame()));
      Branching.Outcome outcome = wait(session.branch(strange).outcome());
      assertTrue(
          assertInstanceOf(Branching.Outcome.Refused.class, outcome)
              .reason()
              .startsWith("the run came out otherwise"));
      assertSame(old, session.robot());
    }
  }

  @Test
  void whoHasStartedTheProgramIsKnownAgain() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP)) {
      List<ControllerState> seen = ran(session, SORTING, 300);
      CompletableFuture<ControllerState> started =
          frame(session, state -> !state.newProgramEvents().isEmpty());
      var _ = session.submit(new ProgramCommand.ReplaceProgram(program(session, SORTING)));
      wait(started);
      assertTrue(session.strangerLast());
      // the one before the frame after which time stood: that is with what happened meanwhile
      wait(session.branch(seen.get(seen.size() - 2)).outcome());
      assertFalse(session.strangerLast());
    }
  }

  @Test
  void signalsThatClientsHadTakenAreFree() throws Exception {
    try (RobotSession session = RobotSession.start(DESKTOP)) {
      wait(session.submit(new IoCommand.ClaimSignal("client", "digital_in[0]")));
      ran(session, SORTING, 300);
      wait(session.branch(200).outcome());
      assertEquals(
          new Reply.Done(),
          wait(session.submit(new IoCommand.ClaimSignal("another", "digital_in[0]"))));
      assertEquals(ProgramState.RUNNING, session.state().program().state());
    }
  }
}
