package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * One window for all tests of a class, because each costs seconds to open. Every test begins on the
 * Run screen with nothing running; at the end nothing may have failed inside.
 */
final class SharedWindow implements BeforeAllCallback, BeforeEachCallback, AfterAllCallback {
  private Path folder;
  private VirtualDisplay display;
  private OpenWindow window;
  private int programs;

  @Override
  public void beforeAll(ExtensionContext context) throws IOException {
    display = VirtualDisplay.start("1440x900");
    folder = Files.createTempDirectory("pendant-window");
    window = OpenWindow.open(display, folder);
  }

  /** The window. */
  OpenWindow window() {
    return window;
  }

  @Override
  public void beforeEach(ExtensionContext context) {
    window.click("rail-run");
    window.press("shift F5");
    window.awaitWords("program-state", "stopped");
  }

  /** Writes a program to disk and opens it as people do; it is not running yet. */
  void program(String... lines) {
    programs++;
    Path file = folder.resolve("program" + programs + ".script");
    try {
      Files.write(file, List.of(lines));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    window.open(file);
  }

  /** Opens a program and starts it by key. */
  void run(String... lines) {
    program(lines);
    window.press("F5");
  }

  @Override
  public void afterAll(ExtensionContext context) throws IOException {
    if (window == null) {
      // Skipped, or the window did not open.
      if (display != null) {
        display.close();
      }
      return;
    }
    try {
      assertEquals("", window.complaints(), "outside of the dispatch thread");
      Path errors = folder.resolve("state/pendant/desktop/errors.txt");
      assertEquals("", Files.exists(errors) ? Files.readString(errors) : "", "internal errors");
    } finally {
      window.close();
      display.close();
      deleteFolder();
    }
  }

  private void deleteFolder() throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path each : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(each);
      }
    }
  }
}
