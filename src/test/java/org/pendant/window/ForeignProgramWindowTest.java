package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A program of PolyScope X in the window: it is shown and run, and nobody writes onto it. */
@Tag("slow")
final class ForeignProgramWindowTest {
  private static final String PICK =
      """
      {"application": {"urscript": {"script": "reset_world_model()"}},
       "program": {
        "programContent": {"guid": "a", "contributedNode": {"type": "ur-program"}, "children": [
          {"guid": "b", "contributedNode": {"type": "ur-code"}, "children": [
            {"guid": "c", "contributedNode": {"type": "ur-assign"},
             "programLabel": [{"value": "count"}]},
            {"guid": "d", "contributedNode": {"type": "ur-wait"},
             "programLabel": [{"value": "0.10 s"}]}]}]},
        "urscript": {"nodeIDList": ["0", "a", "b", "c", "d"], "script":
          "$ 1 \\"ur-program\\"\\n$ 2 \\"ur-code\\"\\n$ 3 \\"ur-assign\\"\\ncount = 41\\n$ 4 \\"ur-wait\\"\\nsleep(0.1)\\ntextmsg(\\"it is \\", count + 1)"}}}
      """;

  @Test
  void isShownHeldAtANodeAndNeverSavedOver(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("pick.urpx");
    Files.writeString(file, PICK);
    Path broken = folder.resolve("broken.urpx");
    Files.writeString(broken, "{\n  \"program\": }");
    try (VirtualDisplay display = VirtualDisplay.start("1440x900")) {
      try (OpenWindow window = OpenWindow.open(display, folder)) {
        window.open(file);
        window.click("rail-program");
        window.awaitWords("program-foreign-text", "reset_world_model");
        shows(window);
        holdsAndRuns(window);
        refusesToSave(window, file);
        window.press("control O");
        window.awaitFocus("open-dialog");
        window.type(broken + "\n");
        window.awaitHidden("open-dialog");
        window.awaitWords("notices", broken + ":2:14: is no JSON: ");
        window.raise();
        assertEquals("", window.complaints());
        window.askToClose();
        window.awaitEnd();
      }
      // what was open is open again, and it is among the recent files
      try (OpenWindow window = OpenWindow.open(display, folder)) {
        window.awaitWords("program-name", "pick.urpx");
        window.click("rail-program");
        window.awaitWords("program-tree", "ur-wait 0.10 s");
        window.press("control E");
        window.awaitWords("program-menu", "pick.urpx");
      }
    }
    Path errors = folder.resolve("state/pendant/desktop/errors.txt");
    assertFalse(Files.exists(errors), () -> "internal errors in " + errors);
  }

  private static void shows(OpenWindow window) {
    String tree = window.words("program-tree");
    for (String each :
        List.of(
            "Line 2, ur-program, level 2",
            "Line 3, ur-code, level 3",
            "Line 4, ur-assign count, level 4",
            "Line 5, ur-wait 0.10 s, level 4")) {
      assertTrue(tree.contains(each), tree);
    }
    window.clickRow("program-tree", "ur-assign count");
    window.awaitWords("program-foreign-lines", "count = 41");
    assertFalse(window.words("program-foreign-lines").contains("sleep"));
    window.press("DELETE");
    window.awaitWords("program-tree", "ur-assign count");
  }

  private static void holdsAndRuns(OpenWindow window) {
    window.clickRow("program-tree", "ur-wait 0.10 s");
    window.press("F9");
    window.press("F5");
    window.awaitWords("program-state", "paused");
    window.perform("Show Variables");
    window.awaitWords("variables-table", "count | 41");
    window.press("F5");
    window.awaitWords("program-state", "stopped");
    window.click("rail-run");
    window.awaitWords("run-messages", "it is 42");
  }

  private static void refusesToSave(OpenWindow window, Path file) throws IOException {
    window.press("control S");
    window.awaitWords("notices", "programs of PolyScope X are read and not written");
    window.clickText("notices", "Close");
    assertEquals(PICK, Files.readString(file));
    window.click("rail-program");
    assertTrue(window.shows("program-foreign-bar"));
  }
}
