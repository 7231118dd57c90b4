package org.pendant.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** How a window opens and ends, in good order and otherwise. */
final class LeavingWindowTest {
  @TempDir Path folder;

  private VirtualDisplay display;

  @BeforeEach
  void startDisplay() throws IOException {
    display = VirtualDisplay.start("1440x900");
  }

  @AfterEach
  void stopDisplay() {
    if (display != null) {
      display.close();
    }
  }

  @Test
  void opensWithAnExampleAndARunningArmThenAsksBeforeItLosesText() throws IOException {
    try (OpenWindow window = OpenWindow.open(display, folder)) {
      window.awaitWords("program-name", "pick_and_place.script");
      window.awaitWords("robot-mode", "running");
      edit(window);
      window.askToClose();
      window.awaitShown("unsaved-save");
      window.click("unsaved-cancel");
      window.awaitHidden("unsaved-cancel");
      window.askToClose();
      window.click("unsaved-quit-without-saving");
      window.awaitEnd();
    }
  }

  @Test
  void textThatWasNotSavedIsOfferedAfterACrash() throws IOException {
    try (OpenWindow window = OpenWindow.open(display, folder)) {
      edit(window);
      window.await("the text is kept", this::kept);
      window.kill();
    }
    try (OpenWindow window = OpenWindow.open(display, folder)) {
      window.awaitWords("notices", "pick_and_place.script");
      window.clickText("notices", "Restore");
      window.click("rail-script");
      window.awaitWords("script-text", "lost = 12");
    }
  }

  private static void edit(OpenWindow window) {
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    window.type("lost = 12\n");
    window.awaitWords("script-text", "lost = 12\n");
    window.awaitWords("program-name", "\u2022");
  }

  private boolean kept() {
    try (Stream<Path> files = Files.walk(folder.resolve("pendant"))) {
      for (Path each : files.filter(file -> file.toString().endsWith(".recovery")).toList()) {
        if (Files.readString(each).contains("lost = 12")) {
          return true;
        }
      }
      return false;
    } catch (IOException e) {
      return false; // it is being written
    }
  }
}
