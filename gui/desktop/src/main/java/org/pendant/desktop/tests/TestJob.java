package org.pendant.desktop.tests;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.pendant.recording.compare.TrackCurves;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestId;
import org.pendant.testing.TestResult;
import org.pendant.testing.coverage.CoverageCollector;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.run.TestPlan;
import org.pendant.testing.run.TestRunner;
import org.pendant.testing.run.TestSettings;
import org.pendant.testing.source.TestCase;

/** Test job: looks for tests once, and runs those that are wanted. */
final class TestJob {
  private final TestSetup setup;
  private final Wish wish;
  private final long seed;
  private final Optional<CoverageCollector> coverage;
  private final AtomicBoolean stopped = new AtomicBoolean();
  private final AtomicReference<TestRunner> runner = new AtomicReference<>();

  /**
   * What came of tests.
   *
   * @param coverage what they have reached; empty where that was not counted
   */
  record Outcome(SuiteResult result, Optional<CoverageReport> coverage) {}

  /** Hears what comes of it, in the thread of the job or one of its tests. */
  interface Listener {
    /** These files are there, or are looked at again. */
    void found(List<FoundFile> files);

    /** A test has ended. */
    void ended(TestResult result);
  }

  /**
   * What is wanted.
   *
   * @param chosen the tests; empty for all
   * @param runs whether they run, too
   * @param covered whether it is counted what they reach
   * @param records whether they are recorded anew that are compared with a recording otherwise
   */
  record Wish(Set<TestId> chosen, boolean runs, boolean covered, boolean records) {
    Wish {
      chosen = Set.copyOf(chosen);
    }
  }

  TestJob(TestSetup setup, Wish wish, long seed) {
    this.setup = setup;
    this.wish = wish;
    this.seed = seed;
    coverage =
        wish.covered() && wish.runs() ? Optional.of(new CoverageCollector()) : Optional.empty();
  }

  boolean runs() {
    return wish.runs();
  }

  /** Whether it looks at all files. */
  boolean all() {
    return wish.chosen().isEmpty();
  }

  boolean wants(TestId test) {
    return all() || wish.chosen().contains(test);
  }

  /** Ends it now; tests that run are given up. */
  void stop() {
    stopped.set(true);
    TestRunner started = runner.get();
    if (started != null) {
      started.stop();
    }
  }

  /** What differed first where a test was compared with its recording. */
  Optional<TrackCurves> difference(TestId test) {
    return setup.files().difference(test);
  }

  boolean stopped() {
    return stopped.get();
  }

  /**
   * Does it; takes long.
   *
   * @throws IOException if a folder cannot be read
   */
  Optional<Outcome> work(Listener listener) throws IOException {
    List<String> names =
        all()
            ? setup.files().find()
            : wish.chosen().stream().map(TestId::file).distinct().sorted().toList();
    List<TestCase> seen = new ArrayList<>();
    TestRunner made =
        new TestRunner(
            setup.files(),
            settings(setup, seed),
            test -> {
              seen.add(test);
              return wants(test.id());
            },
            listener::ended,
            setup.files().goldens(wish.records()),
            coverage);
    runner.set(made);
    if (stopped.get()) {
      made.stop();
    }
    TestPlan plan = made.plan(names);
    listener.found(names.stream().map(name -> found(name, seen, plan.broken())).toList());
    if (!wish.runs()) {
      return Optional.empty();
    }
    SuiteResult result = made.run(plan);
    return Optional.of(new Outcome(result, coverage.map(CoverageCollector::report)));
  }

  /** A file with what was found in it. */
  private static FoundFile found(String name, List<TestCase> tests, List<BrokenTestFile> broken) {
    return new FoundFile(
        name,
        tests.stream().filter(each -> each.id().file().equals(name)).toList(),
        broken.stream()
            .filter(each -> each.file().equals(name))
            .flatMap(each -> each.problems().stream())
            .toList());
  }

  /** Half of the processors are left to the robot in the window. */
  static TestSettings settings(TestSetup setup, long seed) {
    return new TestSettings(
        setup.robot().withSeed(seed),
        seed,
        Math.max(1, Runtime.getRuntime().availableProcessors() / 2),
        TestSettings.STANDARD_TIMEOUT_S,
        TestSettings.STANDARD_WALL_TIMEOUT,
        false);
  }
}
