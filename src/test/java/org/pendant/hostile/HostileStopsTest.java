package org.pendant.hostile;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.client.Served;
import org.pendant.command.Launcher;

/**
 * Whatever runs, a stop acts at once: by the dashboard, by another program, by Ctrl-C and SIGTERM.
 *
 * <p>The computer may be busy, so the best of a few tries counts. {@code -Dpendant.hostile=all}
 * tries every way with every program.
 */
@Tag("slow")
class HostileStopsTest {
  private static final boolean ALL = "all".equals(System.getProperty("pendant.hostile"));

  /** Those that held up the controller before work was charged. */
  private static final List<String> WORST =
      List.of("compare-lists", "print-list", "multiply-matrices", "popup", "run-and-join");

  /** Nobody can stop what has ended with an error of its own. */
  private static final Set<String> ENDING =
      Set.of(
          "literal-of-lists",
          "make-list-of-texts",
          "grow-list",
          "grow-list-of-lists",
          "nest-structs");

  private static final int NUMBER = 210;
  private static final int DASHBOARD = 29_999;
  private static final int PRIMARY = 30_001;
  private static final int TRIES = 5;
  private static final double STOP_S = 0.2;

  private static final int PATIENCE_S = 60;
  private static final String HARMLESS = "def harmless():\n  sleep(1000)\nend\n";
  private static final String FRIENDLY = "def friendly():\n  sleep(0.01)\nend\n";

  @TempDir Path folder;

  /** Something that takes time. */
  private interface Timed {
    double seconds() throws Exception;
  }

  private static double bestOf(Timed timed, double enoughS) throws Exception {
    double best = Double.POSITIVE_INFINITY;
    for (int i = 0; i < TRIES && best > enoughS; i++) {
      best = Math.min(best, timed.seconds());
    }
    return best;
  }

  private static List<Map.Entry<String, String>> programs() {
    return HostilePrograms.all().entrySet().stream()
        .filter(
            program -> ALL ? !ENDING.contains(program.getKey()) : WORST.contains(program.getKey()))
        .toList();
  }

  @Test
  void stopsFromOutsideActAtOnceInAServedBox() throws Exception {
    List<Executable> checks = new ArrayList<>();
    try (Served box = Served.start(NUMBER, folder, List.of("--ready"))) {
      for (Map.Entry<String, String> program : programs()) {
        double byDashboard = bestOf(() -> stopped(box, program.getValue(), true), STOP_S);
        double byUpload = bestOf(() -> stopped(box, program.getValue(), false), STOP_S);
        checks.add(
            () ->
                assertTrue(byDashboard < STOP_S, program.getKey() + ": dashboard " + byDashboard));
        checks.add(() -> assertTrue(byUpload < STOP_S, program.getKey() + ": upload " + byUpload));
      }
      checks.add(() -> assertEquals(0, box.stop()));
      assertAll(checks);
    }
  }

  /**
   * Runs a program and ends it, by the dashboard or another program; seconds until it has ended.
   */
  private static double stopped(Served box, String program, boolean byDashboard)
      throws IOException {
    try (Socket socket = new Socket(box.host(), DASHBOARD)) {
      BufferedReader answers =
          new BufferedReader(
              new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
      answers.readLine();
      ask(socket, answers, "close popup");
      upload(box, program);
      while (!ask(socket, answers, "programState").startsWith("PLAYING")) {
        Thread.onSpinWait();
      }
      long began = System.nanoTime();
      if (byDashboard) {
        ask(socket, answers, "stop");
      } else {
        upload(box, FRIENDLY);
      }
      while (!ask(socket, answers, "programState").startsWith("STOPPED")) {
        Thread.onSpinWait();
      }
      return seconds(began);
    }
  }

  private static double seconds(long beganNs) {
    return (System.nanoTime() - beganNs) / 1e9;
  }

  private static String ask(Socket socket, BufferedReader answers, String line) throws IOException {
    socket.getOutputStream().write((line + "\n").getBytes(StandardCharsets.ISO_8859_1));
    return answers.readLine();
  }

  private static void upload(Served box, String program) throws IOException {
    try (Socket socket = new Socket(box.host(), PRIMARY)) {
      socket.getOutputStream().write(program.getBytes(StandardCharsets.ISO_8859_1));
    }
  }

  @Test
  void signalsEndARun() throws Exception {
    List<Executable> checks = new ArrayList<>();
    // leaving the JVM takes its time as well
    double endS = bestOf(() -> ended(HARMLESS, "TERM"), 0) + STOP_S;
    boolean interrupt = false;
    for (Map.Entry<String, String> program : programs()) {
      for (String signal : ALL ? List.of("INT", "TERM") : List.of(interrupt ? "INT" : "TERM")) {
        double took = bestOf(() -> ended(program.getValue(), signal), endS);
        String shown = program.getKey() + ": " + signal + " " + took + " of " + endS;
        checks.add(() -> assertTrue(took < endS, shown));
      }
      interrupt = !interrupt;
    }
    assertAll(checks);
  }

  /** Runs a program for a moment; seconds from a signal to the end of its process. */
  private double ended(String program, String signal) throws Exception {
    Path file = folder.resolve("hostile.script");
    // says when it has begun
    Files.writeString(file, program.replaceFirst("\\(\\):\n", "():\n  textmsg(\"begun\")\n"));
    Process process =
        Launcher.prepare(folder, "run", "hostile.script")
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try (BufferedReader output = process.inputReader(StandardCharsets.ISO_8859_1)) {
      assertEquals("begun", output.readLine());
      Thread.ofVirtual().start(() -> output.lines().forEach(line -> {}));
      // some frames of it
      assertTrue(!process.waitFor(300, TimeUnit.MILLISECONDS), "it has ended by itself");
      long began = System.nanoTime();
      Process kill = new ProcessBuilder("kill", "-" + signal, Long.toString(process.pid())).start();
      assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS), "it continues");
      assertEquals(0, kill.waitFor());
      assertEquals(signal.equals("INT") ? 130 : 143, process.exitValue());
      return seconds(began);
    } finally {
      process.destroyForcibly();
    }
  }
}
