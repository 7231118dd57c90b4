package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Sweeps of the open program: planned, run, and any run opened. */
@Tag("slow")
final class SweepWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  @Test
  void theOpenProgramIsSweptByKeysAndARunIsOpened() {
    sharedWindow.program("def nap():", "  LONG = 0.5", "  sleep(LONG)", "end");
    window.perform("Sweep: plan one of this program");
    window.awaitWords("sweep-parameters", "LONG");
    window.clickCell("sweep-parameters", "LONG");
    window.press("SPACE");
    window.awaitWords("sweep-count", "5 runs");
    window.perform("Sweep: start");
    window.awaitWords("sweep-progress", "5 of 5 runs");
    assertTrue(window.words("sweep-outcomes").contains("5 finished"));
    window.clickCell("sweep-rows", "0.75");
    window.press("ENTER");
    window.awaitWords("past-banner", "4.rec");
    window.press("ESCAPE");
    window.awaitHidden("past-banner");
  }

  @Test
  void whatIsWrongIsToldBeforeTheStart() {
    sharedWindow.program("def nap():", "  LONG = 0.5", "  sleep(LONG)", "end");
    window.perform("Sweep: plan one of this program");
    window.awaitWords("sweep-wrong", "Nothing is varied yet");
    window.clickCell("sweep-parameters", "LONG");
    window.press("SPACE");
    window.awaitWords("sweep-count", "5 runs");
    window.pick("sweep-method", "Random");
    window.awaitWords("sweep-count", "100 runs");
    window.click("sweep-runs");
    window.press("control A");
    window.type("many");
    window.awaitWords("sweep-wrong", "runs is 'many'");
    assertEquals("no runs yet", window.words("sweep-count"));
    window.press("control A");
    window.type("7");
    window.awaitWords("sweep-count", "7 runs");
  }
}
