package org.pendant.bench;

import java.awt.AWTException;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;

/**
 * How long people wait for {@code ./pendant open}: from the command until its window is on the
 * screen, until that is painted, until the arm is seen in 3D beside its state, and until nothing is
 * left to do. It looks at the screen, so it needs a display with a window manager on which nothing
 * else moves; a virtual one will do.
 */
final class WindowStart {
  private static final int STARTS = 5;
  private static final int LOOK_MS = 4;
  private static final int LONGEST_MS = 60_000;
  private static final double NS_A_MS = 1e6;

  /** Where the window is; its parts are where they are at first. */
  private static final Rectangle WINDOW = new Rectangle(80, 60, 1440, 900);

  /** A part that shows nothing when the window is new, its buttons, and the middle of the arm. */
  private static final Rectangle GROUND = inWindow(300, 640, 8, 8);

  private static final Rectangle BUTTONS = inWindow(10, 120, 60, 400);
  private static final Rectangle ARM = inWindow(950, 200, 350, 250);

  /** Text has so many colours at least, and the arm in its light. */
  private static final int COLORS_OF_TEXT = 10;

  private static final int COLORS_OF_ARM = 200;

  /** So long it takes next to nothing when it has come to rest. */
  private static final int REST_MS = 2_000;

  private static final double REST_CPU_MS = 0.05 * REST_MS;

  private final Robot screen;
  private final boolean toRest;

  private WindowStart(boolean toRest) throws AWTException {
    screen = new Robot();
    this.toRest = toRest;
  }

  /** One start: ms since the command, and processor time of the window's process, ms. */
  private record Start(
      double referenceMs,
      double shownMs,
      double paintedMs,
      double runningMs,
      double shownCpuMs,
      double runningCpuMs,
      double restMs,
      double restCpuMs) {}

  /**
   * Prints a table.
   *
   * @param arguments how many starts, 5 if it is not said; {@code shown} to end each when the arm
   *     is seen; and launchers, for which the starts are made in turn, that of this project if none
   *     is named
   */
  public static void main(String[] arguments) throws Exception {
    List<String> words = new ArrayList<>(List.of(arguments));
    boolean toRest = !words.remove("shown");
    int starts =
        !words.isEmpty() && words.getFirst().matches("\\d+")
            ? Integer.parseInt(words.removeFirst())
            : STARTS;
    if (words.isEmpty()) {
      words.add(System.getProperty("pendant.home", ".") + "/pendant");
    }
    WindowStart measured = new WindowStart(toRest);
    Map<String, List<Start>> all = new LinkedHashMap<>();
    words.forEach(launcher -> all.put(launcher, new ArrayList<>()));
    for (int i = 0; i < starts; i++) {
      for (Map.Entry<String, List<Start>> each : all.entrySet()) {
        each.getValue().add(measured.start(each.getKey()));
      }
    }
    all.forEach(measured::print);
    // The screen's threads would stay.
    System.exit(0);
  }

  private void print(String launcher, List<Start> starts) {
    System.out.printf(
        "%n%s%n| from the command | median | all |%n| --- | ---: | --- |%n", launcher);
    row("window on the screen, ms", starts, Start::shownMs);
    row("painted, ms", starts, Start::paintedMs);
    row("the arm is seen, ms", starts, Start::runningMs);
    row("processor time until the window is on the screen, ms", starts, Start::shownCpuMs);
    row("processor time until the arm is seen, ms", starts, Start::runningCpuMs);
    if (toRest) {
      row("at rest, ms", starts, Start::restMs);
      row("processor time until at rest, ms", starts, Start::restCpuMs);
    }
    row("a fixed computation before each, ms", starts, Start::referenceMs);
  }

  private static void row(String what, List<Start> starts, ToDoubleFunction<Start> number) {
    double[] all = starts.stream().mapToDouble(number).toArray();
    double[] sorted = all.clone();
    Arrays.sort(sorted);
    System.out.printf(
        Locale.ROOT,
        "| %s | %.0f | %s |%n",
        what,
        sorted[sorted.length / 2],
        String.join(
            ", ", Arrays.stream(all).mapToObj(each -> Long.toString(Math.round(each))).toList()));
  }

  private Start start(String launcher) throws Exception {
    Path folder = Files.createTempDirectory("pendant-start");
    Path settings = Files.createDirectories(folder.resolve("pendant")).resolve("settings.txt");
    Files.writeString(
        settings,
        String.format(
            "help.welcomed = true%nwindow.bounds = %d %d %d %d%n",
            WINDOW.x, WINDOW.y, WINDOW.width, WINDOW.height));
    ProcessBuilder command = new ProcessBuilder(launcher, "open").inheritIO();
    command.environment().put("XDG_CONFIG_HOME", folder.toString());
    command.environment().put("XDG_STATE_HOME", folder.toString());
    double referenceMs = reference();
    int empty = look(GROUND).getRGB(0, 0);
    long startNs = System.nanoTime();
    Process process = command.start();
    try {
      await(process, () -> look(GROUND).getRGB(0, 0) != empty);
      double shownMs = since(startNs);
      double shownCpuMs = cpuMs(process);
      await(process, () -> colors(look(BUTTONS)) >= COLORS_OF_TEXT);
      double paintedMs = since(startNs);
      await(process, () -> colors(look(ARM)) >= COLORS_OF_ARM);
      double runningMs = since(startNs);
      double runningCpuMs = cpuMs(process);
      keep(look(WINDOW));
      double[] rest = toRest ? awaitRest(process, startNs) : new double[2];
      return new Start(
          referenceMs, shownMs, paintedMs, runningMs, shownCpuMs, runningCpuMs, rest[0], rest[1]);
    } finally {
      process.destroy();
      process.waitFor();
      await(process, () -> look(GROUND).getRGB(0, 0) == empty);
      forget(folder);
    }
  }

  /** When it began to rest, ms, and what it had taken until then, ms. */
  private static double[] awaitRest(Process process, long startNs) throws InterruptedException {
    while (true) {
      double fromMs = since(startNs);
      double fromCpuMs = cpuMs(process);
      TimeUnit.MILLISECONDS.sleep(REST_MS);
      if (cpuMs(process) - fromCpuMs < REST_CPU_MS) {
        return new double[] {fromMs, fromCpuMs};
      }
      if (since(startNs) > LONGEST_MS) {
        throw new IllegalStateException("the window does not come to rest");
      }
    }
  }

  private static void await(Process process, BooleanSupplier seen)
      throws InterruptedException, IOException {
    long startNs = System.nanoTime();
    while (!seen.getAsBoolean()) {
      if (since(startNs) > LONGEST_MS) {
        throw new IOException("the screen did not change; is there a window manager?");
      }
      TimeUnit.MILLISECONDS.sleep(LOOK_MS);
    }
  }

  /** How fast the processor is just now: always the same work, ms. */
  private static double reference() {
    long startNs = System.nanoTime();
    long sum = 0;
    for (long i = 1; i < 200_000_000; i++) {
      sum += i * 0x9E3779B97F4A7C15L ^ sum >>> 7;
    }
    return sum == 0 ? 0 : since(startNs);
  }

  private static double since(long startNs) {
    return (System.nanoTime() - startNs) / NS_A_MS;
  }

  private static double cpuMs(Process process) {
    return process.toHandle().info().totalCpuDuration().orElseThrow().toNanos() / NS_A_MS;
  }

  private static Rectangle inWindow(int x, int y, int width, int height) {
    return new Rectangle(WINDOW.x + x, WINDOW.y + y, width, height);
  }

  private BufferedImage look(Rectangle part) {
    return screen.createScreenCapture(part);
  }

  private static long colors(BufferedImage image) {
    int width = image.getWidth();
    return IntStream.range(0, width * image.getHeight())
        .map(i -> image.getRGB(i % width, i / width))
        .distinct()
        .count();
  }

  /** What was seen, to be looked at: the robot's state is in it. */
  private static void keep(BufferedImage image) throws IOException {
    Path folder =
        Path.of(System.getProperty("pendant.home", "."), "src", "test", "target", "bench");
    Files.createDirectories(folder);
    ImageIO.write(image, "png", folder.resolve("start.png").toFile());
  }

  private static void forget(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      files.map(Path::toFile).sorted((a, b) -> b.compareTo(a)).forEach(File::delete);
    }
  }
}
