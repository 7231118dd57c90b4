package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** The debug bar, and the script that follows the program. */
@Tag("slow")
final class DebugWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  @TempDir private static Path folder;

  private final OpenWindow window = sharedWindow.window();

  private void toScript() {
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
  }

  @Test
  void theDebugBarStepsAndEndsAPausedProgram() {
    sharedWindow.program(
        "def twice(n):", "  return 2 * n", "end", "a = 1", "a = twice(a)", "sleep(0.5)", "a = 3");
    toScript();
    assertFalse(window.shows("debug-bar-step"));
    for (int i = 0; i < 4; i++) {
      window.press("DOWN");
    }
    window.press("F9");
    window.press("F5");
    window.awaitShown("debug-bar-step");
    window.perform("Show Call stack");
    window.awaitWords("call-stack", "line 5");
    window.click("debug-bar-step-into");
    window.awaitWords("call-stack", "line 2");
    window.click("debug-bar-step-out");
    window.awaitWords("call-stack", "line 6");
    window.click("debug-bar-step");
    window.awaitWords("call-stack", "line 7");
    window.awaitFocus("debug-bar-step");
    window.click("debug-bar-step-back");
    window.awaitShown("past-banner");
    assertFalse(window.shows("debug-bar-step"));
    window.press("alt F5");
    window.click("debug-bar-step-on");
    window.press("ESCAPE");
    window.awaitHidden("past-banner");
    window.tabTo("debug-bar-stop");
    window.press("SPACE");
    window.awaitWords("program-state", "stopped");
    window.awaitHidden("debug-bar-step");
    // It goes when another button has its focus, and those behind it move.
    window.awaitHidden("debug-bar-stop");
    window.click("debug-bar-step-back");
    window.awaitShown("past-banner");
    window.press("ESCAPE");
    window.awaitHidden("past-banner");
  }

  @Test
  void theButtonThatStepsBackStaysUnderThePointerWhenLookingBackBegins() {
    sharedWindow.program("a = 1", "sleep(0.1)", "a = 2", "halt");
    toScript();
    String before = window.place("debug-bar");
    window.press("DOWN");
    window.press("F9");
    window.press("F5");
    window.awaitShown("debug-bar-step");
    window.settle();
    assertEquals(before, window.place("debug-bar"), "the tabs beside it moved at the pause");
    String paused = window.place("debug-bar-step-back");
    window.click("debug-bar-step-back");
    window.awaitShown("past-banner");
    window.settle();
    assertEquals(paused, window.place("debug-bar-step-back"));
    window.press("ESCAPE");
    window.awaitHidden("past-banner");
    window.click("debug-bar-run");
    window.awaitWords("program-state", "stopped");
    window.awaitHidden("debug-bar-step");
    window.settle();
    assertEquals(before, window.place("debug-bar"), "the tabs beside it moved at the end");
    String ended = window.place("debug-bar-step-back");
    window.click("debug-bar-step-back");
    window.awaitShown("past-banner");
    window.settle();
    assertEquals(ended, window.place("debug-bar-step-back"));
    window.press("ESCAPE");
    window.awaitHidden("past-banner");
  }

  @Test
  void theScriptFollowsTheProgramThatRuns() {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < 200; i++) {
      lines.add("# line " + (i + 1));
    }
    lines.addAll(List.of("while True:", "  sleep(0.1)", "end"));
    sharedWindow.program(lines.toArray(new String[0]));
    toScript();
    assertTrue(window.selected("script-follow"));
    window.press("F5");
    window.awaitWords("program-state", "running");
    window.press("DOWN");
    window.await("people have left the line", () -> !window.selected("script-follow"));
    window.press("shift F5");
    window.awaitWords("program-state", "stopped");
    window.press("F5");
    window.await("the next start follows again", () -> window.selected("script-follow"));
    window.press("shift F5");
    window.awaitWords("program-state", "stopped");
  }

  @Test
  void aLoopOfNodesThatNeverWaitsIsToldAtItsNodeAndWhileItRuns() throws IOException {
    Path file = folder.resolve("busy.pendant");
    Files.writeString(
        file,
        """
        pendant program 1
        main
          loop rule=forever
            if condition="get_standard_digital_in(7)"
              script-line code="textmsg(1)"
        """);
    window.open(file);
    window.click("rail-program");
    window.awaitWords("program-tree", "warning: this loop never ends and never waits");
    window.perform("Show Problems");
    window.awaitWords("problems-table", "never waits");
    window.press("F5");
    window.awaitWords(
        "status-text", "The program never waits, so robot time crawls: it is at node");
    window.press("shift F5");
    window.awaitWords("program-state", "stopped");
  }
}
