package org.pendant.client;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.pendant.command.Launcher;

/**
 * Measures the ports of {@code ./pendant serve} from outside: rates and intervals with many
 * clients, beside a bare sender at the same time; a client that does not read; many idle
 * connections; how soon an uploaded program starts; how soon the box is ready. Prints tables for
 * docs/benchmarks.md.
 */
public final class PortRates {
  private static final String HOST = "127.0.0.91";
  private static final String BARE_HOST = "127.0.0.92";
  private static final int RTDE_CLIENTS = 10;
  private static final int REALTIME_CLIENTS = 2;
  private static final int IDLE = 200;
  private static final int UPLOADS = 101;
  private static final int STARTS = 9;
  private static final int PATIENCE_S = 60;
  private static final int MESSAGES_PER_S = 500;

  private static final String MOVING =
      """
      def moving():
        while True:
          movej([0.3, -1.57, -1.57, -1.57, 1.57, 0], a=1.4, v=1.05)
          movej([-0.3, -1.57, -1.57, -1.57, 1.57, 0], a=1.4, v=1.05)
        end
      end
      """;

  private final int lastsS;
  private final List<Receiver> receivers = new ArrayList<>();

  private PortRates(int lastsS) {
    this.lastsS = lastsS;
  }

  /** Measures everything; an argument says for how many seconds instead of 60. */
  public static void main(String[] arguments) throws IOException {
    new PortRates(arguments.length > 0 ? Integer.parseInt(arguments[0]) : 60).run();
  }

  private void run() throws IOException {
    Path folder = Files.createTempDirectory("pendant-ports");
    starts(folder);
    try (Talker box = serve(folder);
        Talker bare =
            Talker.start(
                new ProcessBuilder(
                    "python3",
                    Launcher.home().resolve("src/test/bench/bare_sender.py").toString(),
                    BARE_HOST))) {
      ready(box);
      ready(bare);
      uploads();
      upload(MOVING);
      rates(box, bare);
      stuckClient(box);
      idleConnections();
      receivers.forEach(Receiver::close);
    }
  }

  private static Talker serve(Path folder) {
    ProcessBuilder builder =
        new ProcessBuilder(
            Launcher.home().resolve("pendant").toString(),
            "serve",
            "--ready",
            "--host",
            HOST,
            "--logs",
            folder.toString());
    return Talker.start(builder.directory(folder.toFile()));
  }

  private static void ready(Talker talker) {
    if (talker.awaitLine("ready"::equals, PATIENCE_S).isEmpty()) {
      throw new IllegalStateException("did not get ready:\n" + talker.said());
    }
  }

  private static void starts(Path folder) {
    double[] secondsS = new double[STARTS];
    for (int i = 0; i < STARTS; i++) {
      long begin = System.nanoTime();
      try (Talker box = serve(folder)) {
        ready(box);
        secondsS[i] = (System.nanoTime() - begin) / 1e9;
        box.terminate();
        box.awaitEnd(PATIENCE_S);
      }
    }
    print("start of `pendant serve --ready` until `ready`, median of %d", STARTS);
    print("%.2f s (%.2f to %.2f)", median(secondsS), secondsS[0], secondsS[STARTS - 1]);
  }

  private void rates(Talker box, Talker bare) throws IOException {
    for (int i = 0; i < RTDE_CLIENTS; i++) {
      receivers.add(Receiver.rtde(HOST));
    }
    for (int i = 0; i < REALTIME_CLIENTS; i++) {
      receivers.add(Receiver.realtime(HOST, 30003));
    }
    try (Receiver beside = Receiver.realtime(BARE_HOST, 30003)) {
      pause(3);
      beside.measure((lastsS + 10) * MESSAGES_PER_S);
      Duration before = cpu(box);
      Duration bareBefore = cpu(bare);
      long begin = System.nanoTime();
      measure();
      double passedS = (System.nanoTime() - begin) / 1e9;
      double used = cpu(box).minus(before).toNanos() / 1e9 / passedS;
      double bareUsed = cpu(bare).minus(bareBefore).toNanos() / 1e9 / passedS;
      rateTable("beside each other for " + lastsS + " s");
      print("| bare sender in Python | %s | |", beside.stopwatch().cells());
      print("CPU: box %.1f %% of a core, bare sender %.1f %%", 100 * used, 100 * bareUsed);
    }
  }

  private void measure() {
    for (Receiver each : receivers) {
      each.measure((lastsS + 10) * MESSAGES_PER_S);
    }
    pause(lastsS);
  }

  private void rateTable(String what) {
    print("%n%s:%n", what);
    print("| client | rate | interval error, p95 | p99 | worst | missing |");
    print("| --- | --- | --- | --- | --- | --- |");
    for (int i = 0; i < receivers.size(); i++) {
      Receiver each = receivers.get(i);
      print(
          "| %s | %s | %d%s |",
          i < RTDE_CLIENTS ? "RTDE " + (i + 1) : "real-time " + (i + 1 - RTDE_CLIENTS),
          each.stopwatch().cells(),
          each.gaps(),
          each.ended() ? ", ended" : "");
    }
  }

  private void stuckClient(Talker box) throws IOException {
    long before = residentKb(box);
    try (Socket stuck = new Socket(HOST, 30004)) {
      Receiver.startRtde(stuck.getOutputStream());
      measure();
      rateTable("while an eleventh RTDE client does not read for " + lastsS + " s");
      print("resident memory: %d kB before, %d kB after", before, residentKb(box));
    }
  }

  private void idleConnections() throws IOException {
    List<Socket> idle = new ArrayList<>();
    try {
      for (int i = 0; i < IDLE; i++) {
        idle.add(new Socket(HOST, 29999));
      }
      pause(10);
      int open = 0;
      for (Socket each : idle) {
        each.setSoTimeout(1000 * PATIENCE_S);
        each.getOutputStream().write("robotmode\n".getBytes(StandardCharsets.ISO_8859_1));
        String greetingAndAnswer = line(each) + line(each);
        open += greetingAndAnswer.contains("Robotmode: RUNNING") ? 1 : 0;
      }
      print("%n%d of %d idle connections answer after 10 s", open, IDLE);
    } finally {
      for (Socket each : idle) {
        each.close();
      }
    }
  }

  private static String line(Socket socket) throws IOException {
    StringBuilder line = new StringBuilder();
    for (int next = socket.getInputStream().read();
        next >= 0 && next != '\n';
        next = socket.getInputStream().read()) {
      line.append((char) next);
    }
    return line.toString();
  }

  private static void upload(String program) throws IOException {
    try (Socket socket = new Socket(HOST, 30002)) {
      socket.getOutputStream().write(program.getBytes(StandardCharsets.ISO_8859_1));
      socket.shutdownOutput();
      socket.getInputStream().transferTo(OutputStream.nullOutputStream());
    }
  }

  private static void uploads() throws IOException {
    double[] ms = new double[UPLOADS];
    try (Socket watching = new Socket(HOST, 30001);
        Socket uploading = new Socket(HOST, 30003)) {
      Thread.ofVirtual().start(() -> drain(uploading));
      watching.setSoTimeout(1000 * PATIENCE_S);
      DataInputStream input = new DataInputStream(watching.getInputStream());
      for (int i = 0; i < UPLOADS; i++) {
        String name = "upload" + i;
        String program = "def " + name + "():\n  a = 0\n  while True:\n    sync()\n  end\nend\n";
        long begin = System.nanoTime();
        uploading.getOutputStream().write(program.getBytes(StandardCharsets.ISO_8859_1));
        awaitStarted(input, name);
        ms[i] = (System.nanoTime() - begin) / 1e6;
      }
    }
    double median = median(ms);
    print(
        "upload of a program until PROGRAM_XXX_STARTED, median of %d: %.1f ms (%.1f to %.1f)",
        UPLOADS, median, ms[0], ms[UPLOADS - 1]);
  }

  private static void drain(Socket socket) {
    try {
      socket.getInputStream().transferTo(OutputStream.nullOutputStream());
    } catch (IOException e) {
      // closed at the end of the measurement
      return;
    }
  }

  private static void awaitStarted(DataInputStream input, String name) throws IOException {
    String found = "";
    while (!found.endsWith("PROGRAM_XXX_STARTED" + name)) {
      found = new String(input.readNBytes(input.readInt() - 4), StandardCharsets.ISO_8859_1);
    }
  }

  private static Duration cpu(Talker process) {
    return ProcessHandle.of(process.pid())
        .flatMap(each -> each.info().totalCpuDuration())
        .orElse(Duration.ZERO);
  }

  /** From Linux; 0 elsewhere. */
  private static long residentKb(Talker process) throws IOException {
    Path status = Path.of("/proc/" + process.pid() + "/status");
    if (!Files.exists(status)) {
      return 0;
    }
    return Files.readAllLines(status).stream()
        .filter(line -> line.startsWith("VmRSS:"))
        .map(line -> Long.parseLong(line.replaceAll("[^0-9]", "")))
        .findFirst()
        .orElse(0L);
  }

  /** Sorts {@code values}. */
  private static double median(double[] values) {
    Arrays.sort(values);
    return values[values.length / 2];
  }

  private static void pause(int timeS) {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(timeS);
    for (long left = end - System.nanoTime(); left > 0; left = end - System.nanoTime()) {
      LockSupport.parkNanos(left);
    }
  }

  /** Numbers with a point, whatever the machine's language. */
  @SuppressWarnings("AnnotateFormatMethod") // its annotation is not on the class path
  private static void print(String format, Object... values) {
    System.out.println(String.format(Locale.ROOT, format, values));
  }
}
