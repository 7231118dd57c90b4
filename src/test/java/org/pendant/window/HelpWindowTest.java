package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** Help: where to begin, documentation, keys, examples, and what a function does. */
@Tag("slow")
final class HelpWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  @TempDir Path folder;

  @Test
  void f1ExplainsTheFunctionAtTheCaret() {
    sharedWindow.program("sleep(0.5)");
    window.click("rail-script");
    window.click("script-text");
    window.press("control HOME");
    window.press("F1");
    window.awaitWords("name-help", "Pauses");
    window.press("ESCAPE");
    window.awaitHidden("name-help");
  }

  @Test
  void f1ElsewhereOpensTheDocumentationAndEscapeClosesIt() {
    window.click("rail-log");
    window.press("F1");
    window.awaitFocus("help-pages");
    window.awaitWords("help-text", "The desktop");
    assertEquals("", window.nameless());
    window.press("DOWN");
    window.awaitWords("help-text", "Keyboard shortcuts");
    window.awaitWords("help-text", "Run or resume program");
    window.press("ESCAPE");
    window.awaitHidden("help-text");
  }

  @Test
  void helpClosesForAFileThatIsOpenedAndForAScreenThatIsShown() {
    window.perform("Help and documentation");
    window.awaitFocus("help-pages");
    window.perform("Example: hello");
    window.awaitHidden("help-text");
    window.awaitFocus("script-text");

    window.perform("Help and documentation");
    window.awaitFocus("help-pages");
    window.press("alt 7");
    window.awaitHidden("help-text");
    window.awaitFocus("log-table");
  }

  @Test
  void escapeClosesTheHelpWhileKeysGoElsewhere() {
    window.perform("Help and documentation");
    window.awaitFocus("help-pages");
    window.click("speed-slider");
    window.awaitFocus("speed-slider");
    window.press("ESCAPE");
    window.awaitHidden("help-text");
  }

  @Test
  void sectionsAreFoundByTheirWords() {
    window.perform("Help and documentation");
    window.awaitFocus("help-pages");
    window.click("help-search");
    window.type("checksum");
    window.awaitWords("help-pages", "Safety: ");
    window.clickRow("help-pages", "Safety: ");
    window.awaitWords("help-text", "<h1 id=\"safety-functions\">");
    window.press("ESCAPE");
    window.awaitHidden("help-text");
  }

  @Test
  void linksAreFollowedByKeys() {
    window.perform("Help and documentation");
    window.awaitFocus("help-pages");
    window.awaitWords("help-text", "The desktop");
    window.press("TAB");
    window.awaitFocus("help-text");
    window.press("control T");
    window.press("ENTER");
    window.awaitWords("help-text", "The command line");
    window.press("ESCAPE");
    window.awaitHidden("help-text");
  }

  @Test
  void aboutTellsVersionLogsAndLicence() {
    window.perform("About Pendant");
    window.awaitWords("help-text", "Version");
    window.awaitWords("help-text", "Logs, reports and internal errors");
    window.awaitWords("help-text", "Apache License");
    window.press("ESCAPE");
  }

  @Test
  void exampleOpensAsACopyWithoutAFile() {
    window.perform("Example: palletizing");
    window.awaitWords("program-name", "palletizing.script");
    window.awaitFocus("script-text");
    window.awaitWords("script-text", "describe the pallet as a frame");
  }

  @Test
  void exampleOffersTheInstallationThatItIsMadeFor() {
    window.perform("Example: stack boxes");
    window.awaitWords("notices", "made for the installation stack_boxes.pinst");
    window.clickText("notices", "Use it");
    window.awaitHidden("example-stack_boxes.pinst");
    window.awaitFocus("program-tree");
    window.click("rail-installation");
    window.awaitWords("installation-view", "stack_boxes.pinst");
  }

  @Test
  void cardSaysAtTheVeryFirstStartOnlyWhereToBegin() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("pendant")).resolve("settings.txt");
    Files.createFile(settings);
    try (VirtualDisplay display = VirtualDisplay.start("1440x900")) {
      try (OpenWindow first = OpenWindow.open(display, folder)) {
        first.awaitFocus("welcome-program-run");
        assertEquals("", first.nameless());
        first.click("welcome-file-new");
        first.awaitHidden("welcome-program-run");
        first.awaitWords("program-name", "untitled.pendant");
        first.askToClose();
        first.awaitEnd();
      }
      try (OpenWindow second = OpenWindow.open(display, folder)) {
        second.awaitWords("program-name", "pick_and_place.script");
        assertFalse(second.shows("welcome-program-run"));
      }
    }
  }
}
