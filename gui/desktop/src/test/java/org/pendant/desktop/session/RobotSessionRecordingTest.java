package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.recording.Recording;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

@Timeout(60)
final class RobotSessionRecordingTest {
  private static final String TEXT =
      "n = 1\nmovej([0, -1.2, -1.5, -1.5, 1.5, 0], a=3, v=2)\ntextmsg(\"there\")\n";

  /** Runs a program and answers the frame in which it has ended. */
  private static ControllerState run(RobotSession session) throws Exception {
    Program program = session.load(Source.of("test.script", TEXT)).program().orElseThrow();
    CompletableFuture<ControllerState> ended = new CompletableFuture<>();
    session.addFrameListener(
        state -> {
          if (state.program().state() == ProgramState.STOPPED
              && state.program().ending().isPresent()) {
            ended.complete(state);
          }
        });
    var _ = session.run(program);
    return ended.get(30, TimeUnit.SECONDS);
  }

  @Test
  void everythingIsRecordedFromTheStart() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.setPace(new Pace.Unlimited());
      ControllerState end = run(session);
      Recording recording = session.recording();

      assertEquals(0, recording.firstFrame());
      assertTrue(recording.lastFrame() >= end.frame());
      assertEquals(
          end.arm().targetPositionRad(), recording.at(end.timeS()).arm().targetPositionRad());
      assertEquals("there", recording.log(0, end.timeS()).getLast().text());
      assertEquals("n = 1", recording.programAt(end.timeS()).orElseThrow().source().lineText(1));
    }
  }

  @Test
  void anotherControllerHasAnotherRecording() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.setPace(new Pace.Unlimited());
      run(session);
      session.restart(ControllerOptions.headless().withRobot("ur3e"));

      assertEquals("ur3e", session.recording().arm().id());
      assertTrue(session.recording().programs().isEmpty());
    }
  }

  @Test
  void aBranchHasTheRunUpToItsFrame() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.setPace(new Pace.Unlimited());
      ControllerState end = run(session);
      Recording before = session.recording();
      long frame = before.programs().getFirst().frame() + 90;
      session.branch(frame + 10).outcome().get(30, TimeUnit.SECONDS);
      Recording branch = session.recording();

      assertEquals(0, branch.firstFrame());
      assertTrue(branch.lastFrame() < end.frame(), "last frame " + branch.lastFrame());
      assertEquals(
          before.atFrame(frame).arm().targetPositionRad(),
          branch.atFrame(frame).arm().targetPositionRad());
      assertEquals("test.script", branch.programs().getFirst().source().name());
    }
  }
}
