package org.pendant.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.pendant.desktop.scene.gl.SceneUnavailable;

/**
 * Writes pictures of every screen for the documentation, and to look at: in both themes, at three
 * sizes. Run it by {@code src/test/window/shots}.
 */
final class Shots {
  private static final List<String> SCREENS =
      List.of("run", "script", "move", "io", "installation", "log", "plot");

  private final OpenWindow window;
  private final Path examples;
  private final Path folder;
  private final String suffix;

  private Shots(OpenWindow window, Path examples, Path folder, String suffix) {
    this.window = window;
    this.examples = examples;
    this.folder = folder;
    this.suffix = suffix;
  }

  /**
   * Writes pictures of a usual window into the folder that the first argument names, docs/images of
   * the project, and of a small and of a doubled one into the second; all robots into the first,
   * all forms of nodes into the second.
   */
  public static void main(String[] arguments) throws IOException, SceneUnavailable {
    Path usual = Files.createDirectories(Path.of(arguments[0]));
    Path others = Files.createDirectories(Path.of(arguments[1]));
    ContactSheet.write(usual.resolve("robots.png"));
    Path examples = usual.toRealPath().resolveSibling("../examples").normalize();
    for (String theme : List.of("Light", "Dark")) {
      forms(others, theme);
      take(examples, usual, theme, "1440x900", "1440x900", 1);
      take(examples, others, theme, "1024x700", "1024x700", 1);
      // The window counts in pixels before scaling.
      take(examples, others, theme, "2048x1400", "1024x700", 2);
    }
  }

  /** All forms of nodes in one picture; the display is higher than any of them. */
  private static void forms(Path folder, String theme) throws IOException {
    Path settings = Files.createTempDirectory("pendant-shots");
    FormSheet.prepare(settings);
    try (VirtualDisplay screen = VirtualDisplay.start("1440x1800");
        OpenWindow window = OpenWindow.open(screen, settings)) {
      window.resize("1440x1800");
      window.awaitWords("program-name", "every_node.pendant");
      window.perform("Colours: " + theme);
      FormSheet.write(window, folder.resolve("forms-" + theme.toLowerCase(Locale.ROOT) + ".png"));
    }
  }

  private static void take(
      Path examples, Path folder, String theme, String display, String size, int scale)
      throws IOException {
    Path settings = Files.createTempDirectory("pendant-shots");
    try (VirtualDisplay screen = VirtualDisplay.start(display);
        OpenWindow window = OpenWindow.open(screen, settings, "-Dsun.java2d.uiScale=" + scale)) {
      window.resize(size);
      window.perform("Colours: " + theme);
      new Shots(window, examples, folder, scale == 1 ? "-" + size : "-" + size + "-double")
          .everyScreen(theme);
    }
  }

  private void everyScreen(String theme) throws IOException {
    window.click("rail-run");
    window.press("F5");
    window.awaitWords("run-messages", "trying all the same");
    window.await(
        "the arm is on its way", () -> !window.words("run-joints-base").equals("0.00\u00b0"));
    window.press("F6");
    window.awaitWords("program-state", "paused");
    for (String screen : SCREENS) {
      window.click("rail-" + screen);
      shoot(screen, theme);
    }
    window.press("shift F5");
    window.awaitWords("program-state", "stopped");
    debugger(theme);
    window.press("control shift P");
    window.awaitFocus("palette-query");
    window.type("show");
    window.awaitWords("palette-list", "Show Log");
    shoot("palette", theme);
    window.press("ESCAPE");
    window.awaitHidden("palette-query");
    sweep(theme);
    tree(theme);
    popup(theme);
    question(theme);
    stopCard(theme);
  }

  private void debugger(String theme) throws IOException {
    window.click("rail-script");
    window.click("script-text");
    window.awaitFocus("script-text");
    window.press("control HOME");
    for (int line = 1; line < 22; line++) {
      window.press("DOWN");
    }
    window.press("F9");
    window.press("F5");
    window.awaitWords("program-state", "paused");
    window.perform("Show Variables");
    window.perform("Show Call stack");
    shoot("debug", theme);
    window.press("shift F5");
    window.awaitWords("program-state", "stopped");
    window.perform("Show 3D");
    window.perform("Show the dock at the bottom");
  }

  /** Where the base may stand, from a copy: the results are beside the plan. */
  private void sweep(String theme) throws IOException {
    Path copy = Files.createTempDirectory("pendant-sweep");
    for (String each : List.of("place_base.toml", "place_base.script")) {
      Files.copy(examples.resolve("sweeps").resolve(each), copy.resolve(each));
    }
    window.perform("Sweep: open a plan");
    window.awaitFocus("open-dialog");
    window.type(copy.resolve("place_base.toml") + "\n");
    window.awaitHidden("open-dialog");
    window.awaitWords("sweep-count", "169 runs");
    window.awaitWords("sweep-parameters", "shelf[0]");
    shoot("sweep-plan", theme);
    window.raise();
    window.perform("Sweep: start");
    window.awaitWords("sweep-progress", "169 of 169");
    window.clickCell("sweep-rows", "stopped");
    shoot("sweep", theme);
  }

  private void tree(String theme) throws IOException {
    window.open(examples.resolve("stack_boxes.pendant"));
    window.awaitWords("notices", "stack_boxes.pinst");
    window.clickText("notices", "Open it");
    window.await(
        "the installation is open", () -> !window.words("notices").contains("stack_boxes.pinst"));
    // It tells where the file is, which is of no interest to others.
    window.await(
        "the status line has ended",
        () -> !window.shows("status-text") || window.words("status-text").isBlank());
    window.click("rail-program");
    window.clickRow("program-tree", "Feeder");
    shoot("program", theme);
  }

  private void popup(String theme) throws IOException {
    program("popup(\"Put the next tray into the cell.\", \"Tray is full\", blocking=True)");
    window.press("F5");
    window.awaitShown("popup-text");
    shoot("popup", theme);
    window.press("shift F5");
    window.awaitHidden("popup-text");
  }

  private void question(String theme) throws IOException {
    program("n = request_integer_from_primary_client(\"How many parts are on the tray?\")");
    window.press("F5");
    window.awaitFocus("popup-field");
    window.type("3.5");
    window.press("ENTER");
    window.awaitShown("popup-error");
    shoot("question", theme);
    window.press("shift F5");
    window.awaitHidden("popup-text");
  }

  private void stopCard(String theme) throws IOException {
    program("sleep(0.1)", "protective_stop()", "sleep(1)");
    window.press("F5");
    window.awaitShown("stop-card");
    shoot("stop", theme);
    window.press("shift F5");
    window.await(
        "the arm is ready",
        () -> {
          window.press("F4");
          return window.words("readiness").equals("Ready");
        });
  }

  private void program(String... lines) throws IOException {
    Path file = Files.createTempDirectory("pendant-shot").resolve("station.script");
    Files.write(file, List.of(lines));
    // A popup may have had the keys.
    window.raise();
    window.open(file);
  }

  private void shoot(String what, String theme) throws IOException {
    Path file = folder.resolve(what + "-" + theme.toLowerCase(Locale.ROOT) + suffix + ".png");
    window.settle();
    window.picture(file);
  }
}
