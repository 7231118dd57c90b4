package org.pendant.bench;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.stream.Stream;
import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.CompletionParams;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializedParams;
import org.eclipse.lsp4j.MessageActionItem;
import org.eclipse.lsp4j.MessageParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.ShowMessageRequestParams;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextDocumentItem;
import org.eclipse.lsp4j.VersionedTextDocumentIdentifier;
import org.eclipse.lsp4j.launch.LSPLauncher;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.LanguageServer;

/**
 * How long an editor waits for {@code ./pendant lsp}: a process of its own, in a text of about
 * 5,000 lines that is typed in.
 */
final class LanguageServerLatency implements LanguageClient {
  private static final int STARTS = 11;
  private static final int EDITS = 200;
  private static final int FILES = 200;
  private static final int BYTES_OF_5000_LINES = 210_000;
  private static final double NS_A_MS = 1e6;
  private static final int MS_A_TICK = 10;

  private final BlockingQueue<PublishDiagnosticsParams> diagnostics = new LinkedBlockingQueue<>();
  private Process process;
  private double startCpuMs;
  private LanguageServer server;

  private LanguageServerLatency() {}

  /** Prints a table; of the parts that are named ({@code starts typing files}), else of all. */
  public static void main(String[] arguments) throws Exception {
    List<String> parts =
        arguments.length == 0 ? List.of("starts", "typing", "files") : List.of(arguments);
    System.out.println("| what | median | 95 of 100 | most |");
    System.out.println("| --- | ---: | ---: | ---: |");
    for (String part : parts) {
      switch (part) {
        case "starts" -> starts();
        case "typing" -> new LanguageServerLatency().typing();
        case "files" -> new LanguageServerLatency().files();
        default -> throw new IllegalArgumentException(part + " is no part");
      }
    }
  }

  private static void starts() throws Exception {
    double[] starts = new double[STARTS];
    double[] startsCpu = new double[STARTS];
    for (int i = 0; i < STARTS; i++) {
      LanguageServerLatency client = new LanguageServerLatency();
      starts[i] = client.start();
      startsCpu[i] = client.startCpuMs;
    }
    Arrays.sort(starts);
    Arrays.sort(startsCpu);
    System.out.println(row("start to first diagnostics, ms", starts));
    System.out.println(row("its processor time, ms", startsCpu));
  }

  private static String row(String what, double[] sorted) {
    return String.format(
        Locale.ROOT,
        "| %s | %.1f | %.1f | %.1f |",
        what,
        sorted[sorted.length / 2],
        sorted[sorted.length * 95 / 100],
        sorted[sorted.length - 1]);
  }

  private double start() throws Exception {
    long startNs = System.nanoTime();
    connect();
    open("file:///hello.script", "textmsg(\"hello\")\nslep(1)\n");
    diagnostics.take();
    double tookMs = (System.nanoTime() - startNs) / NS_A_MS;
    startCpuMs = processorMs();
    end();
    return tookMs;
  }

  private void typing() throws Exception {
    connect();
    String text = GeneratedProgram.ofBytes(BYTES_OF_5000_LINES);
    String uri = "file:///long.script";
    open(uri, text);
    diagnostics.take();
    List<String> lines = text.lines().toList();
    int line = lines.size() / 2;
    System.out.println("(" + lines.size() + " lines)");
    double[] checks = new double[EDITS];
    double[] completions = new double[EDITS];
    double cpuMs = processorMs();
    double answeringMs = answeringMs();
    for (int i = 0; i < EDITS; i++) {
      String typed = "  mov" + "ej".substring(0, i % 3) + "\n";
      long editNs = System.nanoTime();
      change(
          uri,
          i + 2,
          new Range(new Position(line, 0), new Position(line + (i == 0 ? 0 : 1), 0)),
          typed);
      long askNs = System.nanoTime();
      var _ =
          server
              .getTextDocumentService()
              .completion(
                  new CompletionParams(
                      new TextDocumentIdentifier(uri), new Position(line, typed.length() - 1)))
              .get();
      completions[i] = (System.nanoTime() - askNs) / NS_A_MS;
      diagnostics.take();
      checks[i] = (System.nanoTime() - editNs) / NS_A_MS;
    }
    double editMs = (processorMs() - cpuMs) / EDITS;
    double answerMs = (answeringMs() - answeringMs) / EDITS;
    Arrays.sort(checks);
    Arrays.sort(completions);
    System.out.println(row("completion after an edit, ms", completions));
    System.out.println(row("diagnostics after an edit, ms", checks));
    System.out.printf(
        Locale.ROOT,
        "processor time for an edit: %.1f ms, of the threads that answer %.1f ms%n",
        editMs,
        answerMs);
    System.out.println("memory (VmRSS): " + memory());
    end();
  }

  private void files() throws Exception {
    connect();
    String text = GeneratedProgram.ofBytes(20_000);
    long startNs = System.nanoTime();
    for (int i = 0; i < FILES; i++) {
      open("file:///" + i + ".script", text);
    }
    for (int i = 0; i < FILES; i++) {
      diagnostics.take();
    }
    System.out.printf(
        Locale.ROOT,
        "%d files of 20 kB opened and checked: %.0f ms; memory %s%n",
        FILES,
        (System.nanoTime() - startNs) / NS_A_MS,
        memory());
    end();
  }

  /** What other work on the machine disturbs least; of all its threads, the compilers' too. */
  private double processorMs() {
    return process.toHandle().info().totalCpuDuration().orElseThrow().toNanos() / NS_A_MS;
  }

  /** That of the threads that answer: those of the JVM, such as its compilers, are others. */
  private double answeringMs() throws IOException {
    long ticks = 0;
    try (Stream<Path> threads = Files.list(Path.of("/proc/" + process.pid() + "/task"))) {
      for (Path thread : threads.toList()) {
        // the name in brackets is cut to 15 letters; the twelfth and thirteenth word behind it
        String[] words = Files.readString(thread.resolve("stat")).split("[()] ?", -1);
        if (words[1].equals("language server")) {
          String[] times = words[2].split(" ", -1);
          ticks += Long.parseLong(times[11]) + Long.parseLong(times[12]);
        }
      }
    }
    return ticks * MS_A_TICK;
  }

  private String memory() throws IOException {
    return Files.readAllLines(Path.of("/proc/" + process.pid() + "/status")).stream()
        .filter(line -> line.startsWith("VmRSS"))
        .findFirst()
        .orElse("unknown");
  }

  private void connect() throws Exception {
    List<String> command =
        new ArrayList<>(List.of(System.getProperty("pendant.home") + "/pendant", "lsp"));
    process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    var launcher =
        LSPLauncher.createClientLauncher(this, process.getInputStream(), process.getOutputStream());
    var _ = launcher.startListening();
    server = launcher.getRemoteProxy();
    InitializeParams asked = new InitializeParams();
    asked.setCapabilities(new ClientCapabilities());
    JsonObject options = new JsonObject();
    options.addProperty("dryRun", "off");
    asked.setInitializationOptions(options);
    server.initialize(asked).get();
    server.initialized(new InitializedParams());
  }

  private void end() throws Exception {
    server.shutdown().get();
    server.exit();
    process.waitFor();
  }

  private void open(String uri, String text) {
    server
        .getTextDocumentService()
        .didOpen(new DidOpenTextDocumentParams(new TextDocumentItem(uri, "urscript", 1, text)));
  }

  private void change(String uri, int version, Range range, String text) {
    server
        .getTextDocumentService()
        .didChange(
            new DidChangeTextDocumentParams(
                new VersionedTextDocumentIdentifier(uri, version),
                List.of(new TextDocumentContentChangeEvent(range, text))));
  }

  @Override
  public void publishDiagnostics(PublishDiagnosticsParams told) {
    diagnostics.add(told);
  }

  @Override
  public void telemetryEvent(Object event) {}

  @Override
  public void showMessage(MessageParams message) {}

  @Override
  public CompletableFuture<MessageActionItem> showMessageRequest(ShowMessageRequestParams asked) {
    return CompletableFuture.completedFuture(null);
  }

  @Override
  public void logMessage(MessageParams message) {}
}
