package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** The menu bar: where things are, and that they can be seen and used. */
@Tag("slow")
final class MenuWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  @TempDir Path folder;

  @Test
  void noMenuHasMoreThanFourteenEntries() {
    window.press("control N");
    window.awaitWords("program-name", "untitled");
    Map<String, Long> entries =
        window.menus().stream()
            .map(line -> line.substring(0, line.lastIndexOf(" > ")))
            .collect(Collectors.groupingBy(each -> each, TreeMap::new, Collectors.counting()));
    assertEquals(Map.of(), only(entries, count -> count > 14));
  }

  private static Map<String, Long> only(Map<String, Long> entries, Predicate<Long> which) {
    return entries.entrySet().stream()
        .filter(each -> which.test(each.getValue()))
        .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue));
  }

  @Test
  void quitIsTheLastEntryOfFile() {
    List<String> file =
        window.menus().stream().filter(line -> line.matches("File > [^>]*")).toList();
    assertEquals("File > Quit", file.getLast());
  }

  @Test
  void everyActionHasAPlaceOfItsOwn() {
    assertEquals(
        List.of(), window.menus().stream().filter(line -> line.startsWith("Tools")).toList());
  }

  @Test
  void menuOfNodesIsThereForProgramsOfNodesOnly() {
    window.press("control N");
    window.awaitShown("menu-nodes");
    window.press("control alt N");
    window.awaitHidden("menu-nodes");
  }

  @Test
  void longMenusFitIntoASmallWindow() {
    window.resize("1024x700");
    for (String each : List.of("file", "edit", "view", "robot")) {
      window.click("menu-" + each);
      String last = window.named("menu-" + each + "-").getLast();
      assertTrue(window.whole(last), last);
      window.press("ESCAPE");
      window.press("ESCAPE");
    }
    window.resize("1440x900");
  }

  @Test
  void checkMarkShowsWhetherADockIsThereAndAClickTurnsItOver() {
    window.click("menu-view");
    window.click("menu-view-docks");
    assertTrue(window.selected("menu-dock-fold-right"));
    window.click("menu-dock-fold-right");
    window.click("menu-view");
    window.click("menu-view-docks");
    assertFalse(window.selected("menu-dock-fold-right"));
    window.click("menu-dock-fold-right");
    window.click("menu-view");
    window.click("menu-view-docks");
    assertTrue(window.selected("menu-dock-fold-right"));
    window.press("ESCAPE");
    window.press("ESCAPE");
  }

  @Test
  void programOfNodesIsExportedAfterAListOfWhatNoRobotKnows() {
    window.perform("Example: stack boxes");
    window.awaitWords("program-name", "stack_boxes.pendant");
    window.press("alt F");
    window.click("menu-file-export");
    window.click("menu-file-export-urp");
    window.awaitWords("urp-export-text", "no robot has loaded such a file yet");
    window.clickText("urp-export", "Export\u2026");
    window.awaitFocus("save-dialog");
    Path file = folder.resolve("boxes.urp");
    window.press("control A");
    window.type(file + "\n");
    window.awaitHidden("save-dialog");
    window.awaitWords("status-text", "Saved " + file);
    assertTrue(Files.exists(file));
    window.raise();
  }

  @Test
  void keysLeadIntoMenusWithinMenus() {
    window.press("alt V");
    window.awaitShown("menu-view-screens");
    window.press("DOWN");
    window.press("RIGHT");
    window.awaitShown("menu-view-log");
    window.press("ESCAPE");
    window.press("ESCAPE");
    window.press("ESCAPE");
  }
}
