package org.pendant.client;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.pendant.command.Launcher;

/**
 * {@code ./pendant serve} with 256 MB under hostile programs, one after the other, each stopped by
 * the dashboard, while three RTDE clients count the frames that they miss. Prints how long stops
 * took, what was missed during which program, and how much memory there was.
 */
public final class Soak implements AutoCloseable {
  private static final String HOST = "127.0.0.93";
  private static final int CLIENTS = 3;
  private static final int PATIENCE_S = 60;
  private static final long RUNS_MS = 3000;
  private static final long STOP_WITHIN_S = 30;

  private final Talker box;
  private final List<Receiver> receivers = new ArrayList<>();
  private final Map<String, Outcome> outcomes = new LinkedHashMap<>();

  /** What became of one program in all its runs. */
  private static final class Outcome {
    private final List<Double> stopsMs = new ArrayList<>();
    private int notStopped;
    private int ended;
    private long missed;
  }

  private Soak(Path folder) throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder(
            Launcher.home().resolve("pendant").toString(),
            "serve",
            "--ready",
            "--host",
            HOST,
            "--logs",
            folder.toString());
    builder.environment().put("PENDANT_JAVA_OPTIONS", "-Xmx256m");
    box = Talker.start(builder.directory(folder.toFile()));
    if (box.awaitLine("ready"::equals, PATIENCE_S).isEmpty()) {
      throw new IllegalStateException("did not get ready:\n" + box.said());
    }
    for (int i = 0; i < CLIENTS; i++) {
      receivers.add(Receiver.rtde(HOST));
    }
  }

  /** {@code minutes}: soaks for so long, 30 unless told otherwise. */
  public static void main(String[] arguments) throws IOException, InterruptedException {
    double minutes = arguments.length > 0 ? Double.parseDouble(arguments[0]) : 30;
    try (Soak soak = new Soak(Files.createTempDirectory("pendant-soak"))) {
      soak.run((long) (minutes * 60));
    }
  }

  private void run(long lastsS) throws IOException, InterruptedException {
    print("heap after a collection, begin: %s", heap());
    print("| after | resident | RTDE missed so far |");
    print("| --- | --- | --- |");
    long beganNs = System.nanoTime();
    long endNs = beganNs + TimeUnit.SECONDS.toNanos(lastsS);
    while (System.nanoTime() < endNs && alive()) {
      for (HostileProgram each : HostileProgram.ALL) {
        if (System.nanoTime() < endNs && alive()) {
          runOne(each);
        }
      }
      print(
          "| %d s | %d MB | %d |",
          TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - beganNs),
          residentKb() >> 10,
          missed());
    }
    print("heap after a collection, end: %s%n", heap());
    table();
  }

  private boolean alive() {
    return ProcessHandle.of(box.pid()).map(ProcessHandle::isAlive).orElse(false);
  }

  private void runOne(HostileProgram program) {
    Outcome outcome = outcomes.computeIfAbsent(program.name(), _ -> new Outcome());
    long before = missed();
    try {
      upload(program.text());
      pause(RUNS_MS);
      stop(outcome);
    } catch (IOException e) {
      outcome.notStopped++;
    }
    outcome.missed += missed() - before;
  }

  private static void upload(String text) throws IOException {
    try (Socket socket = new Socket(HOST, 30002)) {
      socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
      // the connection stays until the program has been compiled
      socket.shutdownOutput();
      socket.setSoTimeout((int) TimeUnit.SECONDS.toMillis(STOP_WITHIN_S));
      socket.getInputStream().transferTo(OutputStream.nullOutputStream());
    }
  }

  private static void stop(Outcome outcome) throws IOException {
    try (Socket socket = new Socket(HOST, 29999);
        BufferedReader answers =
            new BufferedReader(
                new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1))) {
      socket.setSoTimeout((int) TimeUnit.SECONDS.toMillis(STOP_WITHIN_S));
      answers.readLine();
      if (!ask("running", socket, answers).endsWith("true")) {
        outcome.ended++;
        return;
      }
      long beganNs = System.nanoTime();
      String answer = ask("stop", socket, answers);
      while (!answer.startsWith("Stopped")
          && System.nanoTime() - beganNs < TimeUnit.SECONDS.toNanos(STOP_WITHIN_S)) {
        answer = ask("stop", socket, answers);
      }
      if (answer.startsWith("Stopped")) {
        outcome.stopsMs.add((System.nanoTime() - beganNs) / 1e6);
      } else {
        outcome.notStopped++;
      }
    }
  }

  private static String ask(String question, Socket socket, BufferedReader answers)
      throws IOException {
    socket.getOutputStream().write((question + "\n").getBytes(StandardCharsets.ISO_8859_1));
    String answer = answers.readLine();
    if (answer == null) {
      throw new IOException("the dashboard has gone");
    }
    return answer;
  }

  private void table() {
    print("| program | stopped | ended before | not stopped | stop: median | worst | missed |");
    print("| --- | --- | --- | --- | --- | --- | --- |");
    outcomes.forEach(
        (name, outcome) -> {
          double[] sorted = outcome.stopsMs.stream().mapToDouble(each -> each).sorted().toArray();
          print(
              "| %s | %d | %d | %d | %s | %s | %d |",
              name,
              sorted.length,
              outcome.ended,
              outcome.notStopped,
              sorted.length > 0 ? ms(sorted[sorted.length / 2]) : "",
              sorted.length > 0 ? ms(Arrays.stream(sorted).max().orElseThrow()) : "",
              outcome.missed);
        });
    for (int i = 0; i < CLIENTS; i++) {
      Receiver each = receivers.get(i);
      print(
          "RTDE client %d: %d frames, %d missed%s",
          i + 1, each.received(), each.missed(), each.ended() ? ", disconnected" : "");
    }
    if (!alive()) {
      print("the box is gone; it said:%n%s", box.said());
    }
  }

  private static String ms(double value) {
    return String.format(Locale.ROOT, "%.1f ms", value);
  }

  private long missed() {
    return receivers.stream().mapToLong(Receiver::missed).sum();
  }

  /** From Linux; 0 elsewhere. */
  private long residentKb() throws IOException {
    Path status = Path.of("/proc/" + box.pid() + "/status");
    if (!Files.exists(status)) {
      return 0;
    }
    return Files.readAllLines(status).stream()
        .filter(line -> line.startsWith("VmRSS:"))
        .map(line -> Long.parseLong(line.replaceAll("[^0-9]", "")))
        .findFirst()
        .orElse(0L);
  }

  /** What the JDK's own tool says; it stops the box for a moment, so not in between. */
  private String heap() throws IOException, InterruptedException {
    tool("GC.run");
    return tool("GC.heap_info")
        .lines()
        .filter(line -> line.contains("used"))
        .map(String::strip)
        .findFirst()
        .orElse("unknown");
  }

  private String tool(String command) throws IOException, InterruptedException {
    Path jcmd = Path.of(System.getProperty("java.home"), "bin", "jcmd");
    if (!Files.exists(jcmd)) {
      return "";
    }
    Process process =
        new ProcessBuilder(jcmd.toString(), Long.toString(box.pid()), command)
            .redirectErrorStream(true)
            .start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
    process.waitFor();
    return said;
  }

  private static void pause(long timeMs) {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(timeMs);
    for (long left = end - System.nanoTime(); left > 0; left = end - System.nanoTime()) {
      LockSupport.parkNanos(left);
    }
  }

  /** Numbers with a point, whatever the machine's language. */
  @SuppressWarnings("AnnotateFormatMethod") // its annotation is not on the class path
  private static void print(String format, Object... values) {
    System.out.println(String.format(Locale.ROOT, format, values));
  }

  @Override
  public void close() {
    receivers.forEach(Receiver::close);
    box.terminate();
    box.awaitEnd(PATIENCE_S);
    box.close();
  }
}
