package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.language.source.Source;

final class RefreshRhythmTest {
  private static final int CALM_FRAMES = 1000;

  private final Controller controller = new Controller(ControllerOptions.headless());
  private long nowNs;
  private int hurries;
  private final RefreshRhythm rhythm =
      new RefreshRhythm(controller.state(), () -> hurries++, () -> nowNs);

  private void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      nowNs += 2_000_000;
      rhythm.frame(controller.state());
    }
  }

  private void submit(Command command) {
    var _ = controller.submit(command);
    advance(1);
  }

  private void calmDown() {
    advance(CALM_FRAMES);
    assertEquals(RefreshRhythm.SELDOM_MS, rhythm.nextMs(true));
  }

  @Test
  void theWindowIsRefreshedSeldomAsSoonAsNothingHappens() {
    assertEquals(RefreshRhythm.OFTEN_MS, rhythm.nextMs(true));
    calmDown();
    advance(CALM_FRAMES);
    assertEquals(RefreshRhythm.SELDOM_MS, rhythm.nextMs(true));
    assertEquals(0, hurries);
  }

  @Test
  void whereNothingHasHappenedForLongOnlyTheClockIsLeftToShow() {
    calmDown();
    advance(3 * CALM_FRAMES);
    assertEquals(RefreshRhythm.RESTING_MS, rhythm.nextMs(true));
    submit(new BoxCommand.SetSpeedFraction(0.5));
    assertEquals(1, hurries);
    assertEquals(RefreshRhythm.OFTEN_MS, rhythm.nextMs(true));
  }

  @Test
  void whatHappensIsShownAtOnce() {
    calmDown();
    submit(new BoxCommand.SetSpeedFraction(0.5));
    assertEquals(1, hurries);
    assertEquals(RefreshRhythm.OFTEN_MS, rhythm.nextMs(true));
    submit(new BoxCommand.SetSpeedFraction(0.4));
    assertEquals(1, hurries);
  }

  @Test
  void aProgramThatRunsIsShownOftenAlsoWhileItWaits() {
    calmDown();
    Source source = Source.of("test.script", "sleep(10)\n".getBytes(StandardCharsets.ISO_8859_1));
    submit(new ProgramCommand.StartProgram(controller.load(source).program().orElseThrow()));
    advance(CALM_FRAMES);
    assertEquals(RefreshRhythm.OFTEN_MS, rhythm.nextMs(true));
  }

  @Test
  void whoTouchesTheWindowSeesItRefreshedOften() {
    calmDown();
    assertTrue(rhythm.touched());
    assertFalse(rhythm.touched());
    assertEquals(RefreshRhythm.OFTEN_MS, rhythm.nextMs(true));
  }

  @Test
  void aWindowThatNobodySeesIsRefreshedHardlyEverWhateverHappens() {
    assertEquals(RefreshRhythm.HIDDEN_MS, rhythm.nextMs(false));
    submit(new BoxCommand.SetSpeedFraction(0.5));
    assertEquals(0, hurries);
    assertEquals(RefreshRhythm.HIDDEN_MS, rhythm.nextMs(false));
    assertTrue(rhythm.touched());
    assertEquals(RefreshRhythm.OFTEN_MS, rhythm.nextMs(true));
  }
}
