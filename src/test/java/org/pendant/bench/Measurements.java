package org.pendant.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.pendant.client.PortRates;
import org.pendant.window.SteadyRate;

/**
 * Runs the benchmarks as docs/benchmarks.md lists them and prints its tables: medians, in Markdown.
 *
 * <p>Most are measured under two sets of JVM flags: the JVM's own choice, which is what a program
 * that stays open gets, and the flags of {@code ./pendant}, which are made for short runs.
 */
final class Measurements {
  private final Path folder;
  private final String[] launcherFlags;
  private final boolean quick;

  private Measurements(Path home, boolean quick) throws IOException {
    folder = Files.createDirectories(home.resolve("src/test/target/bench"));
    launcherFlags = launcherFlags(home.resolve("pendant"));
    this.quick = quick;
  }

  /**
   * Without arguments all benchmarks run; {@code quick} makes them short, to see whether they work.
   * {@code typing} types in a window instead, {@code tree} opens and scrolls a program tree there,
   * {@code rate} works with one, {@code ports} measures what clients of the ports see, {@code
   * coverage} what coverage costs, {@code lsp} how long editors wait for the language server,
   * {@code start} how long people wait for the window. Any other arguments are those of JMH.
   */
  public static void main(String[] arguments) throws Exception {
    if (arguments.length > 0 && arguments[0].equals("typing")) {
      TypingLatency.main(Arrays.copyOfRange(arguments, 1, arguments.length));
      return;
    }
    if (arguments.length > 0 && arguments[0].equals("tree")) {
      TreeLatency.main(Arrays.copyOfRange(arguments, 1, arguments.length));
      return;
    }
    if (arguments.length > 0 && arguments[0].equals("coverage")) {
      CoverageCost.main(Arrays.copyOfRange(arguments, 1, arguments.length));
      return;
    }
    if (arguments.length > 0 && arguments[0].equals("lsp")) {
      LanguageServerLatency.main(new String[0]);
      return;
    }
    if (arguments.length > 0 && arguments[0].equals("start")) {
      WindowStart.main(Arrays.copyOfRange(arguments, 1, arguments.length));
      return;
    }
    if (arguments.length > 0 && arguments[0].equals("ports")) {
      PortRates.main(Arrays.copyOfRange(arguments, 1, arguments.length));
      return;
    }
    if (arguments.length > 0 && arguments[0].equals("rate")) {
      SteadyRate.main(new String[0]);
      return;
    }
    boolean quick = arguments.length == 1 && arguments[0].equals("quick");
    if (arguments.length > 0 && !quick) {
      new Runner(new CommandLineOptions(arguments)).run();
      return;
    }
    // Maven sets it; other starters are in the project's folder.
    new Measurements(Path.of(System.getProperty("pendant.home", ".")), quick).runAll();
  }

  private void runAll() throws RunnerException, IOException {
    runInterpreter();
    runLanguage();
    runModels();
    runFrames();
    runVirtualTime();
  }

  private void runInterpreter() throws RunnerException, IOException {
    String name = "InterpreterBenchmark";
    List<RunResult> jvm = run(name, warm());
    List<RunResult> launcher = run(name, warm().jvmArgsAppend(launcherFlags));
    List<RunResult> first = run(name, firstRun(3));
    heading(
        "Interpreter, ms",
        "task | default flags | launcher's flags | first run in a process | allocated, kB");
    StringBuilder forComparison = new StringBuilder();
    for (int i = 0; i < jvm.size(); i++) {
      String task = jvm.get(i).getParams().getParam("task");
      row(task, median(jvm, i), median(launcher, i), median(first, i), allocatedKb(jvm, i));
      forComparison.append(
          String.format(Locale.ROOT, "%s %.3f %.3f%n", task, median(jvm, i), median(launcher, i)));
    }
    Files.writeString(folder.resolve("interpreter.txt"), forComparison);
  }

  private void runLanguage() throws RunnerException {
    String name = "LanguageBenchmark";
    List<RunResult> jvm = run(name, warm());
    List<RunResult> launcher = run(name, warm().jvmArgsAppend(launcherFlags));
    List<RunResult> first = run(name, firstRun(5));
    heading(
        "Language, MB/s of a program of 1 MB",
        "step | warm, default flags | warm, launcher's flags | cold, launcher's flags"
            + " | allocated, kB");
    for (int i = 0; i < jvm.size(); i++) {
      row(
          method(jvm.get(i)),
          1_000 / median(jvm, i),
          1_000 / median(launcher, i),
          1_000 / median(first, i),
          allocatedKb(jvm, i));
    }
  }

  private void runModels() throws RunnerException {
    heading(
        "Kinematics, dynamics and the simulated arm, ns",
        "what | default flags | launcher's flags | allocated, bytes");
    for (String name : List.of("KinematicsBenchmark", "DynamicsBenchmark", "ArmBenchmark")) {
      List<RunResult> jvm = run(name, warm());
      List<RunResult> launcher = run(name, warm().jvmArgsAppend(launcherFlags));
      for (int i = 0; i < jvm.size(); i++) {
        String arm = jvm.get(i).getParams().getParam("does");
        row(
            arm == null ? method(jvm.get(i)) : "a frame of the arm: " + arm,
            median(jvm, i),
            median(launcher, i),
            allocatedKb(jvm, i) * 1_000);
      }
    }
  }

  private void runFrames() throws RunnerException {
    String name = "FrameBenchmark";
    List<RunResult> jvm = run(name, warm());
    List<RunResult> launcher = run(name, warm().jvmArgsAppend(launcherFlags));
    heading(
        "One frame, us",
        "the thread waits for | default flags | launcher's flags | allocated, bytes");
    for (int i = 0; i < jvm.size(); i++) {
      row(
          jvm.get(i).getParams().getParam("waitsFor"),
          median(jvm, i),
          median(launcher, i),
          allocatedKb(jvm, i) * 1_000);
    }
  }

  private void runVirtualTime() throws RunnerException {
    String name = "VirtualTimeBenchmark";
    List<RunResult> jvm = run(name, warm());
    List<RunResult> launcher = run(name, warm().jvmArgsAppend(launcherFlags));
    List<RunResult> first = run(name, firstRun(5));
    heading(
        "A minute of virtual time, ms",
        "program | default flags | launcher's flags | first run in a process | allocated, kB");
    row(
        "moves, waits, I/O",
        median(jvm, 0),
        median(launcher, 0),
        median(first, 0),
        allocatedKb(jvm, 0));
  }

  private ChainedOptionsBuilder warm() {
    ChainedOptionsBuilder options = new OptionsBuilder();
    if (quick) {
      options.warmupIterations(1).warmupTime(TimeValue.milliseconds(200));
      options.measurementIterations(1).measurementTime(TimeValue.milliseconds(200));
    }
    return options;
  }

  /** One run in each of several new JVMs: classes are loaded and nothing is compiled yet. */
  private ChainedOptionsBuilder firstRun(int forks) {
    return new OptionsBuilder()
        .mode(Mode.SingleShotTime)
        .warmupIterations(0)
        .measurementIterations(1)
        .forks(quick ? 1 : forks)
        .jvmArgsAppend(launcherFlags);
  }

  private List<RunResult> run(String name, ChainedOptionsBuilder options) throws RunnerException {
    System.err.println("measuring: " + name);
    Collection<RunResult> results =
        new Runner(
                options
                    .include("\\." + name + "\\.")
                    .addProfiler(GCProfiler.class)
                    .shouldFailOnError(true)
                    .output(folder.resolve("jmh.log").toString())
                    .build())
            .run();
    return new ArrayList<>(results);
  }

  /** Of the runs, of the iterations, or of the forks: whatever JMH kept. */
  private static double median(List<RunResult> results, int i) {
    return results.get(i).getPrimaryResult().getStatistics().getPercentile(50);
  }

  /** Memory that one operation allocates, in 1000 bytes. */
  private static double allocatedKb(List<RunResult> results, int i) {
    return results.get(i).getSecondaryResults().get("gc.alloc.rate.norm").getScore() / 1_000;
  }

  private static String method(RunResult result) {
    String name = result.getParams().getBenchmark();
    return name.substring(name.lastIndexOf('.') + 1);
  }

  private static void heading(String title, String columns) {
    System.out.printf("%n### %s%n%n| %s |%n", title, columns);
    System.out.println("| --- " + "| ---: ".repeat(columns.split("\\|", -1).length - 1) + "|");
  }

  private static void row(String name, double... numbers) {
    StringBuilder row = new StringBuilder("| ").append(name);
    for (double number : numbers) {
      String format = number < 10 ? " | %.2f" : number < 100 ? " | %.1f" : " | %.0f";
      row.append(String.format(Locale.ROOT, format, number));
    }
    System.out.println(row.append(" |"));
  }

  /** The words of the launcher's line {@code flags='...'}. */
  private static String[] launcherFlags(Path launcher) throws IOException {
    for (String line : Files.readAllLines(launcher)) {
      if (line.startsWith("flags='")) {
        return line.substring("flags='".length(), line.lastIndexOf('\'')).split(" ", -1);
      }
    }
    throw new IOException(launcher + " has no line that begins with flags='");
  }
}
