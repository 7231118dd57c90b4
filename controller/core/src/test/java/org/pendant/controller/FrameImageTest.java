package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.pendant.controller.state.ArmReadings;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;

/** Snapshots, which are made for those who ask. */
final class FrameImageTest {
  private static final long GIVE_UP_S = 20;
  private static final String MOVES = "movej([1, -1, -1, -1, 1, 1])\n";

  private final Controller controller = new Controller(ControllerOptions.headless());

  private void start(String text) {
    Source source = Source.of("test.script", text.getBytes(StandardCharsets.ISO_8859_1));
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(controller.load(source).program().orElseThrow()));
    advance(1);
  }

  private void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
    }
  }

  @Test
  void aSnapshotStaysAsItIsWhileFramesPass() {
    start(MOVES);
    advance(100);
    ControllerState state = controller.state();
    Joints targetRad = state.arm().targetPositionRad();
    Joints actualRad = state.arm().actualPositionRad();
    ArmReadings readings = state.readings();
    Joints torqueNm = readings.torqueNm();
    advance(100);
    assertNotEquals(state.frame(), controller.state().frame());
    assertNotEquals(targetRad, controller.state().arm().targetPositionRad());
    assertNotEquals(torqueNm, controller.state().readings().torqueNm());
    assertEquals(targetRad, state.arm().targetPositionRad());
    assertEquals(actualRad, state.arm().actualPositionRad());
    assertEquals(torqueNm, state.readings().torqueNm());
  }

  @Test
  void everybodyGetsTheSameSnapshotOfAFrame() throws Exception {
    advance(3);
    CompletableFuture<ControllerState> elsewhere = CompletableFuture.supplyAsync(controller::state);
    assertSame(controller.state(), elsewhere.get(GIVE_UP_S, TimeUnit.SECONDS));
  }

  @Test
  void whoLooksLaterSeesTheSameAsWhoLooksAtEachFrame() {
    Controller watched = new Controller(ControllerOptions.headless());
    Source source = Source.of("test.script", MOVES.getBytes(StandardCharsets.ISO_8859_1));
    var _ =
        watched.submit(
            new ProgramCommand.StartProgram(watched.load(source).program().orElseThrow()));
    start(MOVES);
    advance(299);
    for (int i = 0; i < 300; i++) {
      watched.advance();
      assertEquals(i + 1, watched.state().frame());
    }
    assertEquals(watched.state().arm().actualPositionRad(), actualRad());
    assertEquals(watched.state().readings(), controller.state().readings());
    assertEquals(watched.state().safety(), controller.state().safety());
  }

  private Joints actualRad() {
    return controller.state().arm().actualPositionRad();
  }

  @Test
  void newsOfAFrameThatNobodyLookedAtAreNotThoseOfTheNext() {
    start("textmsg(\"said\")\nsleep(1)\n");
    long newest = controller.state().newestEntry();
    assertTrue(newest > 0);
    advance(1);
    assertEquals(List.of(), controller.state().newEntries());
    assertEquals(newest, controller.state().newestEntry());
  }
}
