package org.pendant.hostile;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * No program holds up a frame, in a process with little memory.
 *
 * <p>What is measured is the processor time of the thread that does the frames, since other work on
 * the computer would count otherwise. {@code -Dpendant.hostile=all} watches each program for
 * longer.
 */
@Tag("slow")
class HostileScriptsTest {
  private static final boolean ALL = "all".equals(System.getProperty("pendant.hostile"));

  /** Seconds of processor time for each program. */
  private static final double SECONDS = ALL ? 2 : 0.05;

  private static final int PATIENCE_S = 1200;

  /** The computer may be busy, and code is slower before the JVM has compiled it. */
  private static final double MAX_LONG = 0.01;

  private static final int MAX_LONG_FRAMES = 3;
  private static final long MAX_NS = 200_000_000;
  private static final long MAX_MEAN_NS = 6_000_000;

  /** How programs may end by themselves. */
  private static final Set<String> ENDINGS =
      Set.of("", "out-of-memory", "too-large", "list-capacity");

  @TempDir Path folder;

  @Test
  void noProgramHoldsUpAFrameOrAnotherThreadOrItsStop() throws Exception {
    List<FrameTimes> seen = watched();
    assertEquals(
        List.copyOf(HostilePrograms.all().keySet()), seen.stream().map(FrameTimes::name).toList());
    assertAll(seen.stream().map(times -> () -> check(times)));
  }

  private List<FrameTimes> watched() throws IOException, InterruptedException {
    Path results = folder.resolve("frames");
    Path output = folder.resolve("output");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx256m",
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                FrameWatch.class.getName(),
                results.toString(),
                Double.toString(SECONDS))
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    try {
      assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS), "it has not ended");
      assertEquals(0, process.exitValue(), () -> said(output));
    } finally {
      process.destroyForcibly();
    }
    return Files.readAllLines(results).stream().map(FrameTimes::of).toList();
  }

  private static String said(Path output) {
    try {
      return Files.readString(output);
    } catch (IOException e) {
      return e.toString();
    }
  }

  private static void check(FrameTimes times) {
    String shown = times.toString();
    assertTrue(ENDINGS.contains(times.ending()), shown);
    assertTrue(times.longFrames() <= Math.max(MAX_LONG_FRAMES, MAX_LONG * times.frames()), shown);
    assertTrue(times.longestNs() < MAX_NS, shown);
    // a few frames say nothing of the mean: their code is not compiled yet
    assertTrue(!ALL || times.meanNs() < MAX_MEAN_NS, shown);
    assertTrue(times.beats() >= times.frames() - times.frames() / 10 - 1, shown);
    assertTrue(times.unharmed(), shown);
  }
}
