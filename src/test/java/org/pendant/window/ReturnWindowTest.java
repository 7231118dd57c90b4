package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Coming back to a program after the window was closed. */
@Tag("slow")
final class ReturnWindowTest {
  @TempDir private Path folder;

  @Test
  void breakpointsCaretAndFoldsOutliveTheWindow() throws IOException {
    Path file = folder.resolve("count.script");
    Files.write(
        file,
        List.of(
            "def add(n):",
            "  return n + 1",
            "end",
            "count = 0",
            "while count < 10:",
            "  count = add(count)",
            "end",
            "textmsg(\"it is \", count)"));
    try (VirtualDisplay display = VirtualDisplay.start("1440x900");
        OpenWindow window = OpenWindow.open(display, folder, List.of(file))) {
      window.awaitWords("program-name", "count.script");
      window.click("rail-script");
      window.click("script-text");
      window.awaitFocus("script-text");
      window.press("control HOME");
      window.press("control PERIOD");
      for (int i = 0; i < 3; i++) {
        window.press("DOWN");
      }
      window.press("F9");
      window.press("shift F9");
      window.awaitFocus("breakpoint-condition");
      window.type("count == 4\n");
      window.awaitWords("breakpoints-table", "count == 4");
      window.askToClose();
      window.awaitEnd();
    }
    // A display begins anew when its last window has gone.
    try (VirtualDisplay display = VirtualDisplay.start("1440x900");
        OpenWindow window = OpenWindow.open(display, folder)) {
      window.awaitWords("program-name", "count.script");
      window.perform("Show Breakpoints");
      window.awaitWords("breakpoints-table", "count == 4");
      window.click("rail-script");
      window.awaitWords("editor-place", "6");
      window.press("F5");
      window.awaitWords("program-state", "paused");
      window.perform("Show Variables");
      window.awaitWords("variables-table", "count | 4");
      assertEquals("", window.complaints(), "outside of the dispatch thread");
    }
  }

  @Test
  void theBreakpointOfANodeOutlivesTheWindow() throws IOException {
    Path file = folder.resolve("wait.pendant");
    Files.writeString(
        file,
        """
        pendant program 1
        main
          script-line code="textmsg(1)"
          script-line code="sync()"
        """);
    try (VirtualDisplay display = VirtualDisplay.start("1440x900");
        OpenWindow window = OpenWindow.open(display, folder, List.of(file))) {
      window.awaitWords("program-name", "wait.pendant");
      window.click("rail-program");
      window.clickRow("program-tree", "sync");
      window.press("F9");
      window.perform("Show Breakpoints");
      window.awaitWords("breakpoints-table", "22");
      window.askToClose();
      window.awaitEnd();
    }
    // A display begins anew when its last window has gone.
    try (VirtualDisplay display = VirtualDisplay.start("1440x900");
        OpenWindow window = OpenWindow.open(display, folder)) {
      window.awaitWords("program-name", "wait.pendant");
      window.perform("Show Breakpoints");
      window.awaitWords("breakpoints-table", "22");
      window.press("F5");
      window.awaitWords("program-state", "paused");
    }
  }
}
