package org.pendant.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Measures whether the controller keeps 500 Hz in real time while a user is busy with the window:
 * sizes it, turns pages of a program, changes screens. Prints a row for docs/benchmarks.md.
 */
public final class SteadyRate {
  private static final double LASTS_S = 30;
  private static final double FRAMES_PER_SECOND = 500;

  private SteadyRate() {}

  /** Works with a window for half a minute; the arguments are not used. */
  public static void main(String[] arguments) throws IOException {
    Path settings = Files.createTempDirectory("pendant-rate");
    Path program = settings.resolve("busy.script");
    Files.writeString(program, program());
    try (VirtualDisplay screen = VirtualDisplay.start("1440x900");
        OpenWindow window = OpenWindow.open(screen, settings)) {
      window.open(program);
      window.click("rail-script");
      window.click("script-text");
      window.press("F5");
      window.awaitWords("program-state", "running");
      long begin = System.nanoTime();
      double beginS = robotTimeS(window);
      int rounds = 0;
      double least = 100;
      while ((System.nanoTime() - begin) / 1e9 < LASTS_S) {
        window.resize(rounds % 2 == 0 ? "1100x760" : "1400x860");
        window.press("PAGE_DOWN");
        window.press(rounds % 8 == 7 ? "control HOME" : "PAGE_DOWN");
        window.click(rounds % 6 < 3 ? "rail-script" : "rail-io");
        least = Math.min(least, pacePercent(window));
        rounds++;
      }
      double passedS = (System.nanoTime() - begin) / 1e9;
      double rate = (robotTimeS(window) - beginS) / passedS * FRAMES_PER_SECOND;
      System.out.printf(
          Locale.ROOT,
          "| window sized, paged and changed %d times in %.0f s | %.2f Hz | %.0f %% of real time in"
              + " the worst 2 s (above 95 counts as 100) |%n",
          rounds,
          passedS,
          rate,
          least);
    }
  }

  private static double robotTimeS(OpenWindow window) {
    return Double.parseDouble(window.words("robot-time").replace(" s", "").strip());
  }

  private static double pacePercent(OpenWindow window) {
    return window.shows("status-frames")
        ? Double.parseDouble(window.words("status-frames").replaceAll("[^0-9.]", ""))
        : 100;
  }

  private static String program() {
    StringBuilder text = new StringBuilder("def busy():\n  while True:\n");
    for (int i = 0; i < 400; i++) {
      text.append("    movej([")
          .append(i % 2 == 0 ? "0.3" : "-0.3")
          .append(", -1.57, -1.57, -1.57, 1.57, 0], r=0.02)\n");
    }
    return text.append("  end\nend\n").toString();
  }
}
