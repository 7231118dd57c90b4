package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two windows, each a process, that have one file open. */
@Tag("slow")
final class TwoWindowsTest {
  @TempDir Path folder;

  private VirtualDisplay display;
  private Path file;

  @BeforeEach
  void startDisplay() throws IOException {
    display = VirtualDisplay.start("1440x900");
    file = Files.writeString(folder.resolve("mine.script"), "old = 1\n");
  }

  @AfterEach
  void stopDisplay() {
    if (display != null) {
      display.close();
    }
  }

  @Test
  void bothAreToldAndWhatOneSavesTheOtherReads() throws IOException {
    try (OpenWindow first = OpenWindow.open(display, folder, List.of(file))) {
      first.awaitWords("program-name", "mine.script");
      try (OpenWindow second = OpenWindow.open(display, folder, List.of(file))) {
        second.awaitWords("other-window-text", "mine.script is open in another Pendant window");
        first.awaitWords("other-window-text", "mine.script is open in another Pendant window");
        edit(second, "newer = 2\n");
        second.press("control S");
        first.awaitWords("status-text", "mine.script has changed on disk and was read again");
        assertEquals("newer = 2\nold = 1\n", Files.readString(file));
        second.askToClose();
        second.awaitEnd();
      }
      first.awaitHidden("other-window-text");
    }
  }

  @Test
  void aKilledWindowHasNothingOpenAnyMore() throws IOException {
    try (OpenWindow first = OpenWindow.open(display, folder, List.of(file))) {
      try (OpenWindow second = OpenWindow.open(display, folder, List.of(file))) {
        first.awaitWords("other-window-text", "mine.script is open in another Pendant window");
        second.kill();
      }
      first.awaitHidden("other-window-text");
    }
  }

  @Test
  void savingOverWhatOthersHaveJustWrittenAsks() throws IOException {
    try (OpenWindow window = OpenWindow.open(display, folder, List.of(file))) {
      window.awaitWords("program-name", "mine.script");
      edit(window, "mine = 2\n");
      // Before the window has looked at the file again by itself.
      Files.writeString(file, "theirs = 3\n");
      window.press("control S");
      window.awaitWords("notices", "has changed");
      assertEquals("theirs = 3\n", Files.readString(file));
      window.settle();
      window.clickText("notices", "Read it again");
      window.awaitWords("script-text", "theirs = 3");
    }
  }

  private static void edit(OpenWindow window, String text) {
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    window.type(text);
    window.awaitWords("script-text", text);
  }
}
