package org.pendant.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** Writing, running and debugging programs in the window. */
@Tag("slow")
final class ProgramWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  @TempDir static Path folder;

  private final OpenWindow window = sharedWindow.window();

  @Test
  void runByKeyMovesTheArmAndLogsWhatItSays() {
    sharedWindow.program(
        "movej([0.3, -1.5, -1.5, -1.5, 1.5, 0], a=5, v=3)", "textmsg(\"arrived\")");
    window.press("F5");
    window.awaitWords("run-joints-base", "17.19");
    window.awaitWords("program-state", "stopped");
    window.click("rail-log");
    window.awaitWords("log-table", "arrived");
  }

  @Test
  void pausedProgramGoesOnAndStops() {
    sharedWindow.run("while True:", "  sync()", "end");
    window.awaitWords("program-state", "running");
    window.press("F6");
    window.awaitWords("program-state", "paused");
    window.press("F5");
    window.awaitWords("program-state", "running");
    window.press("shift F5");
    window.awaitWords("program-state", "stopped");
  }

  @Test
  void mistakeIsExplainedWhileTyping() {
    sharedWindow.program("i = 1");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    window.type("j = k\n");
    window.awaitWords("program-name", "\u2022");
    window.perform("Show Problems");
    window.awaitWords("problems-table", "variable k is never assigned");
    window.click("script-text");
    window.press("control Z");
    window.press("control Z");
    window.press("control S");
  }

  @Test
  void theMomentThatPeopleLookAtIsToldByTheNodeOfATree() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("greet.pendant"),
            """
            pendant program 1
            main
              script-line code="sleep(0.1)"
              script-line code="textmsg(1)"
            """);
    window.open(file);
    window.press("F5");
    window.awaitWords("run-state", "greet.pendant, finished");
    window.awaitWords("program-state", "stopped");
    window.perform("Step back");
    window.awaitShown("past-banner");
    window.awaitWords("run-name", "greet.pendant");
    window.awaitWords("run-node", "2  sleep(0.1)");
    window.press("ESCAPE");
    window.awaitHidden("past-banner");
  }

  @Test
  void forcedInputIsSeenByTheProgram() {
    sharedWindow.run(
        "while not get_standard_digital_in(3):",
        "  sync()",
        "end",
        "set_standard_digital_out(5, True)",
        "textmsg(\"part seen\")");
    window.click("rail-io");
    window.click("digital-in-3");
    window.awaitWords("program-state", "stopped");
    window.click("rail-run");
    window.awaitWords("run-messages", "part seen");
    window.click("rail-io");
    window.click("digital-in-3");
  }

  @Test
  void programIsHeldAtABreakpointSteppedAndGivenAnotherValue() {
    sharedWindow.program("count = 1", "count = count + 1", "textmsg(\"it is \", count)");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    window.press("DOWN");
    window.press("F9");
    window.press("F5");
    window.awaitWords("program-state", "paused");
    window.perform("Show Variables");
    window.awaitWords("variables-table", "count | 1");
    window.press("F10");
    window.awaitWords("variables-table", "count | 2");
    window.clickCell("variables-table", "2");
    window.press("F2");
    window.awaitFocus("variables-table-field");
    window.press("control A");
    window.type("41\n");
    window.awaitWords("variables-table", "count | 41");
    window.press("F5");
    window.awaitWords("program-state", "stopped");
    window.click("rail-run");
    window.awaitWords("run-messages", "it is 41");
  }

  @Test
  void theWorstMomentOfARunIsExplained() {
    sharedWindow.program(
        "movej([0.3, -1.5, -1.5, -1.5, 1.5, 0], a=5, v=3)",
        "movej([-0.3, -1.5, -1.5, -1.5, 1.5, 0], a=5, v=3)");
    window.press("F5");
    window.awaitWords("run-joints-base", "-17.19");
    window.awaitWords("program-state", "stopped");
    window.perform("Timeline: to the worst moment before");
    window.perform("Show Motion");
    window.awaitWords("motion-text", "movej(");
    window.awaitWords("motion-table", "Following error");
    window.perform("Timeline: back to now");
  }

  @Test
  void theLastRunIsComparedWithVariantsOfIt() {
    sharedWindow.program("movej([0.3, -1.5, -1.5, -1.5, 1.5, 0], a=5, v=3)", "sleep(0.1)");
    window.press("F5");
    window.awaitWords("run-joints-base", "17.19");
    window.awaitWords("program-state", "stopped");
    window.perform("Show What if");
    window.clickCell("whatif-table", "50 %");
    window.press("F2");
    window.awaitFocus("whatif-speed");
    window.press("control A");
    window.type("500\n");
    window.awaitWords("whatif-refusal", "must be 1 to 100 %");
    window.press("control A");
    window.type("20\n");
    window.awaitHidden("whatif-refusal");
    window.click("whatif-run");
    window.awaitWords("whatif-table", "20 % | as it was | as it ran | Finished");
    window.awaitFocus("whatif-table");
    window.perform("What if: clear the results");
    window.await("no results", () -> !window.words("whatif-table").contains("Finished"));
  }

  @Test
  void aLogpointWritesWhileTheProgramRunsOn() {
    sharedWindow.program("count = 0", "while count < 3:", "  count = count + 1", "end");
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    window.press("DOWN");
    window.press("DOWN");
    window.press("alt F9");
    window.awaitFocus("breakpoint-message");
    window.type("count was {count}\n");
    window.awaitWords("breakpoints-table", "count was {count}");
    window.press("F5");
    window.awaitWords("breakpoints-table", " | 3");
    window.awaitWords("program-state", "stopped");
    window.click("rail-log");
    window.awaitWords("log-table", "count was 2");
  }
}
