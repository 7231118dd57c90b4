package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.pendant.command.service.TestFinder;
import org.pendant.command.text.CommandLanguage;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.coverage.CoverageCollector;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.report.CoverageTable;
import org.pendant.testing.report.ConsoleReport;
import org.pendant.testing.report.ConsoleStyle;
import org.pendant.testing.report.ConsoleStyle.Detail;
import org.pendant.testing.report.ConsoleStyle.Feature;
import org.pendant.testing.report.GithubAnnotations;
import org.pendant.testing.report.ReportLanguage;
import org.pendant.testing.run.TestPlan;
import org.pendant.testing.run.TestRunner;
import org.pendant.testing.source.TestCase;

/** Command {@code pendant test [PATH...]}: runs tests of robot programs. */
final class TestCommand implements Subcommand {
  /** How often files are looked at, ms. */
  private static final long WATCH_MS = 300;

  static final Option LIST = Option.flag("--list");
  private static final Option VERBOSE = Option.flag("--verbose");
  static final Option WATCH =
      Option.flag("--watch")
          .documented(
              "run the tests again whenever one of the files changes that they have read, or a file"
                  + " of tests comes; Ctrl-C ends");
  private static final Option QUIET = Option.flag("--quiet");
  private static final Option COLOR =
      Option.of("--color", new OptionArgument.Choice("auto", "always", "never"))
          .standing("auto")
          .documented(
              "never",
              "whether the text has colours: `always`, `never`, or `auto` (default) where it goes"
                  + " to a terminal and `NO_COLOR` is not set");
  private static final Option GITHUB = Option.flag("--github");

  private final DesktopServices services;

  /**
   * The command.
   *
   * @param services draw pictures of red tests
   */
  TestCommand(DesktopServices services) {
    this.services = services;
  }

  @Override
  public String name() {
    return "test";
  }

  @Override
  public String operands() {
    return "[PATH...]";
  }

  @Override
  public List<Option> options() {
    return Stream.of(
            List.of(LIST, WATCH, VERBOSE, QUIET, COLOR, GITHUB, GoldenRecordings.UPDATE),
            List.of(TargetTests.TARGET),
            TestReports.ALL,
            TestMutation.ALL,
            TestOptions.ALL)
        .flatMap(List::stream)
        .toList();
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (arguments.has(VERBOSE) && arguments.has(QUIET)) {
      throw new UsageException(text("verboseOrQuiet"));
    }
    if (arguments.has(GoldenRecordings.UPDATE) && TestMutation.wanted(arguments)) {
      throw new UsageException(text("updateOrMutate"));
    }
    TestOptions options = TestOptions.of(arguments);
    if (arguments.has(TargetTests.TARGET)) {
      return TargetTests.of(arguments).run(options, arguments, console);
    }
    InstallationOption.tell(arguments, console);
    try (Interruption interruption = Interruption.listen("theTestRun")) {
      TestFilesOnDisk disk = new TestFilesOnDisk(arguments);
      ExitCode code = once(arguments, options, disk, interruption, console);
      while (arguments.has(WATCH) && awaitChange(arguments, disk, interruption, console)) {
        disk = new TestFilesOnDisk(arguments);
        code = again(arguments, options, disk, interruption, console);
      }
      // before the interruption is closed: after that the process may be gone at any moment
      console.flush();
      return code;
    }
  }

  /** Waits until a file has changed that the tests have read, or there is another one. */
  private static boolean awaitChange(
      Arguments arguments, TestFilesOnDisk disk, Interruption interruption, Console console) {
    console.print(text("waitingForChange"));
    console.flush();
    FileChanges changes = new FileChanges(disk.names(), arguments.operands());
    while (!interruption.awaitRequest(WATCH_MS)) {
      if (changes.any()) {
        console.print("");
        return true;
      }
    }
    return false;
  }

  /** As {@link #once}, where a file may be half written or gone: that is told, and mended later. */
  private ExitCode again(
      Arguments arguments,
      TestOptions options,
      TestFilesOnDisk disk,
      Interruption interruption,
      Console console) {
    try {
      return once(arguments, options, disk, interruption, console);
    } catch (UsageException e) {
      console.complain("pendant test: " + CommandLanguage.shown(e.getMessage()));
      return ExitCode.WRONG_USAGE;
    }
  }

  private ExitCode once(
      Arguments arguments,
      TestOptions options,
      TestFilesOnDisk disk,
      Interruption interruption,
      Console console)
      throws UsageException {
    List<String> files = files(arguments);
    ConsoleReport report = report(arguments, disk, console);
    Optional<CoverageCollector> coverage =
        TestReports.wantCoverage(arguments) || TestMutation.wanted(arguments)
            ? Optional.of(new CoverageCollector())
            : Optional.empty();
    GoldenRecordings goldens = new GoldenRecordings(disk, arguments.has(GoldenRecordings.UPDATE));
    TestRunner runner =
        new TestRunner(
            disk, options.settings(), options::wants, report::finished, goldens, coverage);
    TestPlan plan = runner.plan(files).shard(options.shardNumber(), options.shardCount());
    var _ = TestReports.of(arguments, disk);
    var _ = TestMutation.of(arguments, options.settings());
    if (arguments.has(LIST)) {
      return list(plan, console);
    }
    if (plan.tests().isEmpty() && plan.broken().isEmpty()) {
      throw new UsageException(text("noTestMatches"));
    }
    SuiteResult result = run(runner, plan, report, interruption);
    if (github(arguments)) {
      GithubAnnotations.lines(result).forEach(console::print);
    }
    if (!arguments.has(QUIET)) {
      goldens.written().forEach(each -> console.print(text("recordedFile", each)));
    }
    console.flush();
    // again: by now it is known which programs the tests have read
    TestReports reports = TestReports.of(arguments, disk);
    Optional<TestMutation> mutation = TestMutation.of(arguments, options.settings());
    reports.write(
        result,
        Optional.of(
            new RedTests(runner, plan, goldens, options.settings().controller(), services)));
    ExitCode mutated = ExitCode.DONE;
    if (coverage.isPresent()) {
      CoverageReport reached = coverage.get().report();
      reports.write(reached);
      if (arguments.has(TestReports.COVERAGE)) {
        console.print("");
        CoverageTable.of(reached, CommandLanguage.texts(CoverageTable.class))
            .lines()
            .forEach(console::print);
      }
      if (mutation.isPresent()) {
        mutated = mutation.get().run(disk, runner, result, reached, interruption, console);
      }
    }
    return code(result).or(mutated);
  }

  /** What people see of tests, in their language. */
  static ConsoleReport report(Arguments arguments, TestFilesOnDisk disk, Console console)
      throws UsageException {
    return new ConsoleReport(
        style(arguments),
        disk::source,
        console::printPiece,
        new ReportLanguage(CommandLanguage.texts(ReportLanguage.class), CommandLanguage::shown));
  }

  static List<String> files(Arguments arguments) throws UsageException {
    List<String> paths = arguments.operands().isEmpty() ? List.of(".") : arguments.operands();
    try {
      List<String> files = TestFinder.find(paths);
      if (files.isEmpty()) {
        throw new UsageException(text("noFileIn", TestFinder.ENDING, String.join(", ", paths)));
      }
      return files;
    } catch (IOException e) {
      throw UsageException.fromEnglish(e);
    }
  }

  private static SuiteResult run(
      TestRunner runner, TestPlan plan, ConsoleReport report, Interruption interruption) {
    report.begin(plan.tests().stream().map(TestCase::id).toList());
    SuiteResult result = cancellable(interruption, runner, () -> runner.run(plan));
    report.end(result);
    return result;
  }

  /** Has a runner do something, which Ctrl-C cancels. */
  static <T> T cancellable(Interruption interruption, TestRunner runner, Supplier<T> work) {
    Thread watch = watch(interruption, runner::cancel);
    T result = work.get();
    watch.interrupt();
    return result;
  }

  /** Has Ctrl-C do something, until the thread is interrupted that is answered. */
  static Thread watch(Interruption interruption, Runnable cancel) {
    interruption.hold();
    Thread watch =
        Thread.ofVirtual()
            .unstarted(
                () -> {
                  // the wait ends as well where the work has
                  if (interruption.awaitRequest(Long.MAX_VALUE) && interruption.requested()) {
                    cancel.run();
                  }
                });
    watch.start();
    return watch;
  }

  static ExitCode list(TestPlan plan, Console console) {
    for (TestCase each : plan.tests()) {
      console.print(each.id().file() + ":" + each.id().name());
    }
    plan.broken().forEach(file -> file.problems().forEach(console::complainFromEnglish));
    plan.warnings().forEach(file -> file.lines().forEach(console::complainFromEnglish));
    return plan.broken().isEmpty() ? ExitCode.DONE : ExitCode.DOES_NOT_COMPILE;
  }

  static boolean github(Arguments arguments) {
    return arguments.has(GITHUB) || "true".equals(System.getenv("GITHUB_ACTIONS"));
  }

  static ConsoleStyle style(Arguments arguments) throws UsageException {
    Set<Feature> features = EnumSet.of(Feature.WALL_TIME);
    boolean terminal = isTerminal();
    String colour = arguments.word(COLOR).orElseThrow();
    if (terminal) {
      features.add(Feature.TERMINAL);
    }
    if (colour.equals("always") || (colour.equals("auto") && terminal && wantsColour())) {
      features.add(Feature.COLOURS);
    }
    Detail detail = Detail.NORMAL;
    if (arguments.has(VERBOSE)) {
      detail = Detail.VERBOSE;
    } else if (arguments.has(QUIET)) {
      detail = Detail.QUIET;
    }
    return new ConsoleStyle(detail, features);
  }

  /** Whether people watch. */
  static boolean isTerminal() {
    // there is none where output does not go to a terminal, whatever its documentation promises
    return Optional.ofNullable(System.console()).filter(each -> each.isTerminal()).isPresent()
        && System.getenv("CI") == null;
  }

  /** What most programs heed: no-color.org, and a terminal that cannot. */
  private static boolean wantsColour() {
    return System.getenv("NO_COLOR") == null && !"dumb".equals(System.getenv("TERM"));
  }

  static ExitCode code(SuiteResult result) {
    Optional<ExitCode> red = result.firstRed().map(_ -> ExitCode.TESTS_FAILED);
    return red.orElse(result.broken().isEmpty() ? ExitCode.DONE : ExitCode.DOES_NOT_COMPILE);
  }
}
