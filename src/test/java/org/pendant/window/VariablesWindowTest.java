package org.pendant.window;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Variables of a program that runs, in the panel, on the Run screen and in charts. */
@Tag("slow")
final class VariablesWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  private void runCounting() {
    sharedWindow.run(
        "count = 0",
        "limit = 5",
        "place = p[1, 2, 3, 0, 0, 0]",
        "while True:",
        "  count = count + 1",
        "  sync()",
        "end");
    window.perform("Show Variables");
    window.awaitWords("variables-table", "limit | 5");
  }

  @Test
  void valuesGoOnAndCanBeChangedWhileTheProgramRuns() {
    runCounting();
    String before = window.words("variables-table");
    window.await("count continues", () -> !window.words("variables-table").equals(before));
    window.clickCell("variables-table", "5");
    window.press("F2");
    window.awaitFocus("variables-table-field");
    window.press("control A");
    window.type("2 * 21\n");
    window.awaitWords("variables-table", "limit | 42");
    window.awaitWords("program-state", "running");
  }

  @Test
  void favouriteComesFirstOnTheRunScreen() {
    runCounting();
    window.clickCell("variables-table", "limit");
    window.press("S");
    window.await(
        "limit comes first",
        () -> {
          String words = window.words("variables-table");
          return words.indexOf("limit") < words.indexOf("count");
        });
    window.click("rail-run");
    window.awaitWords("run-variables", "limit 5 count");
    window.clickCell("variables-table", "limit");
    window.press("S");
  }

  @Test
  void variableIsDrawnByKeyInEveryFrame() {
    runCounting();
    window.clickCell("variables-table", "count");
    window.press("P");
    window.awaitWords("status-text", "count is drawn on the Plots screen");
    window.click("rail-plot");
    window.awaitShown("plot-value-var:count");
    window.await(
        "the value is known", () -> !window.words("plot-value-var:count").contains("\u2013"));
    window.awaitWords("plot-quantities", "Script variables");
    window.click("plot-remove-var:count");
    window.awaitHidden("plot-value-var:count");
  }

  @Test
  void theFilterLeavesWhatHasTheTextInItsName() {
    runCounting();
    window.click("variables-filter");
    window.awaitFocus("variables-filter");
    window.type("pla");
    window.await("limit is gone", () -> !window.words("variables-table").contains("limit"));
    window.awaitWords("variables-table", "place");
    window.press("ESCAPE");
    window.awaitWords("variables-table", "limit");
  }
}
