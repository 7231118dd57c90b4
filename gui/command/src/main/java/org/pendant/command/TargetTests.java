package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.command.remote.RobotTarget;
import org.pendant.command.remote.TargetAddress;
import org.pendant.command.text.CommandLanguage;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.remote.TargetTrouble;
import org.pendant.testing.report.ConsoleReport;
import org.pendant.testing.report.GithubAnnotations;
import org.pendant.testing.run.TargetRunner;
import org.pendant.testing.run.TestPlan;
import org.pendant.testing.run.TestSettings;
import org.pendant.testing.source.TestCase;

/**
 * Target tests: {@code pendant test --target HOST}, whose programs run on a robot elsewhere.
 *
 * @param address where that is
 */
record TargetTests(TargetAddress address) {
  /** A limit that no test reaches, where people have set none. */
  private static final Duration NO_LIMIT = Duration.ofDays(365);

  /** A target that answers nothing any more is given up within that time after Ctrl-C. */
  private static final int PATIENCE_S = 30;

  static final Option TARGET =
      Option.text("--target", "HOST[:N]")
          .documented(
              "192.168.0.10",
              "run the programs under test on the robot or simulator there, which moves, and skip"
                  + " the tests that need what cannot be done there, see"
                  + " [testing.md](testing.md#against-a-real-robot). `HOST:N` adds N to each port,"
                  + " as `--port-offset` of `serve` does");

  /** What only tests have that run in a controller of their own. */
  private static final List<Option> OTHERS =
      Stream.of(
              List.of(
                  TestCommand.WATCH,
                  GoldenRecordings.UPDATE,
                  TestReports.RECORD_ON_FAILURE,
                  TestReports.COVERAGE,
                  TestReports.LCOV,
                  TestReports.COBERTURA,
                  TestReports.COVERAGE_HTML,
                  TestOptions.JOBS),
              TestMutation.ALL)
          .flatMap(List::stream)
          .toList();

  static TargetTests of(Arguments arguments) throws UsageException {
    for (Option each : OTHERS) {
      if (arguments.has(each)) {
        throw new UsageException(text("notForTarget", each.name()));
      }
    }
    String text = arguments.text(TARGET);
    return new TargetTests(
        TargetAddress.parse(text)
            .orElseThrow(() -> new UsageException(text("targetMustBe", text))));
  }

  ExitCode run(TestOptions options, Arguments arguments, Console console) throws UsageException {
    InstallationOption.tell(arguments, console);
    TestFilesOnDisk disk = new TestFilesOnDisk(arguments);
    ConsoleReport report = TestCommand.report(arguments, disk, console);
    TargetRunner runner =
        new TargetRunner(
            disk, settings(options.settings(), arguments), options::wants, report::finished);
    TestPlan plan =
        runner
            .plan(TestCommand.files(arguments))
            .shard(options.shardNumber(), options.shardCount());
    var _ = TestReports.of(arguments, disk);
    if (arguments.has(TestCommand.LIST)) {
      return TestCommand.list(plan, console);
    }
    if (plan.tests().isEmpty() && plan.broken().isEmpty()) {
      throw new UsageException(text("noTestMatches"));
    }
    try (Interruption interruption = Interruption.listen("theTestRun", PATIENCE_S)) {
      SuiteResult result = run(runner, plan, report, interruption, console);
      if (TestCommand.github(arguments)) {
        GithubAnnotations.lines(result).forEach(console::print);
      }
      console.flush();
      TestReports.of(arguments, disk).write(result, Optional.empty());
      console.flush();
      return TestCommand.code(result);
    } catch (TargetTrouble e) {
      console.flush();
      console.complain(
          "pendant test: " + address.host() + ": " + CommandLanguage.shown(e.getMessage()));
      return ExitCode.UNAVAILABLE;
    }
  }

  /** Tests have the time that they say, by the clock of the target. */
  private static TestSettings settings(TestSettings given, Arguments arguments) {
    return new TestSettings(
        given.controller(),
        given.seed(),
        1,
        given.timeoutS(),
        arguments.has(TestOptions.WALL_TIMEOUT) ? given.wallTimeout() : NO_LIMIT,
        given.failFast());
  }

  private SuiteResult run(
      TargetRunner runner,
      TestPlan plan,
      ConsoleReport report,
      Interruption interruption,
      Console console)
      throws TargetTrouble {
    Thread watch = TestCommand.watch(interruption, runner::cancel);
    try {
      report.begin(plan.tests().stream().map(TestCase::id).toList());
      SuiteResult result =
          runner.count(plan) == 0 ? runner.skipped(plan) : connected(runner, plan, console);
      report.end(result);
      return result;
    } finally {
      watch.interrupt();
    }
  }

  private void warn(long count, Console console) {
    console.complain(
        count == 1
            ? text("robotMovesForOneTest", address.host())
            : text("robotMovesForTests", address.host(), count));
    console.flush();
  }

  private SuiteResult connected(TargetRunner runner, TestPlan plan, Console console)
      throws TargetTrouble {
    try (RobotTarget target = RobotTarget.connect(address)) {
      return runner.run(plan, target, () -> warn(runner.count(plan), console));
    }
  }
}
