package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Moving by hand, and what the log leads to. */
@Tag("slow")
final class HandWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  private double number(String name) {
    return Double.parseDouble(window.words(name));
  }

  @Test
  void stepsMoveTheToolByTheirSizeByMouseAndKey() {
    window.click("rail-move");
    window.awaitShown("move-step-coarse");
    window.click("move-step-coarse");
    double before = number("move-pose-z");
    window.click("move-z-down");
    window.press("PAGE_DOWN");
    window.await(
        "the tool goes down by two steps",
        () -> Math.abs(number("move-pose-z") - (before - 20)) < 0.05);
    window.click("move-step-held");
  }

  @Test
  void jointBeyondItsLimitIsRefusedAtItsField() {
    window.click("rail-move");
    window.click("move-joint-elbow");
    window.press("control A");
    window.type("400");
    window.awaitWords("move-joints-problem", "Elbow: must be -363.000 to 363.000 deg");
    window.click("move-reset-joints");
    window.await("the arm is shown", () -> !window.words("move-joint-elbow").equals("400"));
  }

  @Test
  void messageLeadsToTheLineThatWroteIt() {
    sharedWindow.run("i = 1", "textmsg(\"from line two\")");
    window.awaitWords("program-state", "stopped");
    window.click("rail-log");
    window.awaitWords("log-table", "from line two");
    window.clickCell("log-table", "from line two");
    window.awaitWords("log-detail", "from line two");
    assertEquals("Go to line 2", window.words("log-show-source"));
    window.click("log-show-source");
    window.awaitFocus("script-text");
  }
}
