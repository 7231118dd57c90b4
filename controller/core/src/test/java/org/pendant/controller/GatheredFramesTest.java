package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.StateStream;
import org.pendant.language.source.Source;
import org.pendant.script.vm.ProgramState;

/** Frames that nobody needs on time, which a clock may gather. */
final class GatheredFramesTest {
  private static final int STEADY_FRAMES = 500;

  private final Controller controller = new Controller(ControllerOptions.headless());

  private void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
    }
  }

  private void start(String text) {
    Source source = Source.of("test.script", text.getBytes(StandardCharsets.ISO_8859_1));
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(controller.load(source).program().orElseThrow()));
    controller.advance();
  }

  @Test
  void aCommandThatHasArrivedIsForTheFrameAfterThoseWhoseTimeIsOver() {
    CompletableFuture<Reply> reply = controller.submit(new BoxCommand.SetSpeedFraction(0.5));
    controller.advanceBeforeCommands();
    assertFalse(reply.isDone());
    assertEquals(1, controller.state().arm().speedFraction());
    assertEquals(1, controller.state().frame());
    controller.advance();
    assertEquals(new Reply.Done(), reply.join());
    assertEquals(0.5, controller.state().arm().speedFraction());
  }

  @Test
  void anArmThatRestsNeedsNoFrameOnTime() {
    advance(STEADY_FRAMES);
    assertTrue(controller.needsNoFrameOnTime());
  }

  @Test
  void aProgramNeedsThemAlsoWhileItWaits() {
    advance(STEADY_FRAMES);
    start("sleep(10)\n");
    assertEquals(ProgramState.RUNNING, controller.state().program().state());
    assertFalse(controller.needsNoFrameOnTime());
  }

  @Test
  void anArmNeedsThemUntilItHasComeToRest() {
    start("movej([1, -1, -1, -1, 1, 1])\n");
    advance(100);
    var _ = controller.submit(new ProgramCommand.StopProgram());
    advance(2);
    assertEquals(ProgramState.STOPPED, controller.state().program().state());
    assertFalse(controller.needsNoFrameOnTime());
    advance(1000);
    assertTrue(controller.needsNoFrameOnTime());
  }

  @Test
  void whoFollowsFrameByFrameNeedsThem() {
    advance(STEADY_FRAMES);
    StateStream.Subscription follower = controller.feed().follow();
    assertFalse(controller.needsNoFrameOnTime());
    follower.close();
    assertTrue(controller.needsNoFrameOnTime());
  }
}
