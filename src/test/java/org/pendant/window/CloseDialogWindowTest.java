package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** How a window opens and ends, in good order and otherwise. */
@Tag("slow")
final class CloseDialogWindowTest {
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

  @Test
  void savingFromTheQuestionGoesOnQuitting() throws IOException {
    Path file = folder.resolve("mine.script");
    Files.writeString(file, "old = 1\r\n");
    try (OpenWindow window = OpenWindow.open(display, folder)) {
      openProgram(window, file);
      edit(window);
      window.press("control Q");
      window.awaitFocus("unsaved-save");
      window.press("SPACE");
      window.awaitEnd();
    }
    assertEquals("lost = 12\r\nold = 1\r\n", Files.readString(file));
  }

  @Test
  void aProgramWithoutAFileIsSavedAndThenTheWindowCloses() throws IOException {
    Path file = folder.resolve("new.script");
    try (OpenWindow window = OpenWindow.open(display, folder)) {
      edit(window);
      window.askToClose();
      window.click("unsaved-save");
      window.awaitFocus("save-dialog");
      window.press("ESCAPE");
      window.awaitHidden("save-dialog");
      window.awaitWords("program-name", "\u2022");
      // Without a window manager nobody else gives the window the focus.
      window.click("rail-run");
      window.awaitFocus("pendant");
      window.askToClose();
      window.click("unsaved-save");
      window.awaitFocus("save-dialog");
      window.press("control A");
      window.type(file + "\n");
      window.awaitEnd();
    }
    assertTrue(Files.readString(file).startsWith("lost = 12\n"));
  }

  @Test
  void changesOfOthersAreReadOrAskedAbout() throws IOException {
    Path file = folder.resolve("mine.script");
    Files.writeString(file, "old = 1\n");
    try (OpenWindow window = OpenWindow.open(display, folder)) {
      openProgram(window, file);
      window.click("rail-script");
      window.awaitShown("script-text");
      // Before the first look nobody knows the file's age.
      window.await(
          "it is read again",
          () -> {
            write(file, "newer = " + System.nanoTime() + "\n");
            return window.words("script-text").contains("newer");
          });
      // What was written last may be read only now, and must not come between the keys.
      String last = Files.readString(file).strip();
      window.awaitWords("script-text", last);
      edit(window);
      write(file, "newest = 3\n");
      window.awaitWords("notices", "has changed on disk, and here too");
      window.settle();
      window.clickText("notices", "Read it again");
      window.awaitWords("script-text", "newest = 3");
      window.await("it is not modified", () -> window.words("program-name").equals("mine.script"));
      Files.delete(file);
      window.awaitWords("program-name", "\u2022");
      window.press("control S");
      window.await("it is there again", () -> Files.exists(file));
    }
  }

  @Test
  void aBrokenSettingsFileIsToldAndKept() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("pendant")).resolve("settings.txt");
    Files.writeString(settings, "look.theme = dark\n\u00e9 ?\nfile.recent = a\u0000b\n");
    try (OpenWindow window = OpenWindow.open(display, folder)) {
      window.awaitWords("notices", "has lines that are no settings: 2");
      window.await("what could be read is kept", () -> window.brightness("header") < 100);
    }
    assertTrue(Files.exists(folder.resolve("pendant/settings.txt.bad")));
  }

  @Test
  void settingsThatCannotBeWrittenAreToldAndEverythingElseWorks() throws IOException {
    Files.writeString(folder.resolve("pendant"), "not a folder");
    try (OpenWindow window = OpenWindow.open(display, folder)) {
      window.click("rail-log");
      window.awaitWords("notices", "Settings cannot be written");
      edit(window);
      window.awaitWords("notices", "cannot be kept against a crash");
    }
    assertEquals("not a folder", Files.readString(folder.resolve("pendant")));
  }

  @Test
  void filesThatCannotBeOpenedAreToldInTheWindow() throws IOException {
    Path binary = folder.resolve("a.script");
    Files.write(binary, new byte[] {1, 0, 2});
    Path good = folder.resolve("good.script");
    Files.writeString(good, "fine = 1\n");
    Files.writeString(folder.resolve("beside.script"), "fine = 2\n");
    try (OpenWindow window =
        OpenWindow.open(display, folder, List.of(binary, folder.resolve("none.script"), good))) {
      window.awaitWords("notices", "a.script: it is no text");
      window.awaitWords("notices", "none.script: there is no such file");
      window.awaitWords("program-name", "good.script");
      window.await("it is remembered", () -> settings().contains("file.open = " + good));
      window.press("control O");
      window.awaitFocus("open-dialog");
      window.type("beside.script\n");
      window.awaitWords("program-name", "beside.script");
      window.awaitHidden("open-dialog");
      window.raise();
      window.await("both are remembered", () -> settings().contains("beside.script"));
    }
    try (OpenWindow window = OpenWindow.open(display, folder)) {
      window.awaitWords("program-name", "beside.script");
    }
  }

  @Test
  void installationThatIsNamedIsOpened() throws IOException {
    Path cell = folder.resolve("cell.pinst");
    Files.writeString(cell, "pendant installation 1\n");
    try (OpenWindow window = OpenWindow.open(display, folder, List.of(cell))) {
      window.awaitWords("status-text", "Opened the installation");
      window.awaitWords("program-name", "pick_and_place.script");
    }
  }

  private String settings() {
    try {
      return Files.readString(folder.resolve("pendant/settings.txt"));
    } catch (IOException e) {
      return ""; // not written yet
    }
  }

  private static void openProgram(OpenWindow window, Path file) {
    window.open(file);
  }

  private static void write(Path file, String text) {
    try {
      Files.writeString(file, text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
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
    } catch (IOException | UncheckedIOException e) {
      return false; // it is being written: its first form vanishes under the eyes of the walk
    }
  }
}
