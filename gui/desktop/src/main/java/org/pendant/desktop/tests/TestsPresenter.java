package org.pendant.desktop.tests;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.pendant.kit.background.Background;
import org.pendant.kit.text.Messages;
import org.pendant.recording.compare.TrackCurves;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestId;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.source.TestCase;

/**
 * Tests presenter: finds the tests of a folder and runs them elsewhere, several at once. One thread
 * uses it, the dispatch thread.
 */
final class TestsPresenter {
  private final Supplier<Optional<TestSetup>> setup;
  private final Worker worker;
  private final Executor dispatch;
  private final LongSupplier seeds;
  private final BooleanSupplier covered;
  private final Map<TestId, TestResult> results = new HashMap<>();
  private final Map<Path, CoverStrip.Reached> reached = new HashMap<>();
  private final Map<TestId, TrackCurves> curves = new HashMap<>();
  private final Set<TestId> waiting = new HashSet<>();
  private List<FoundFile> files = List.of();
  private Optional<TestSetup> shown = Optional.empty();
  private Optional<TestJob> job = Optional.empty();
  private Optional<SuiteResult> last = Optional.empty();
  private Optional<CoverageReport> coverage = Optional.empty();
  private String trouble = "";
  private int done;
  private long changes;

  /** Does what is slow elsewhere, as {@link Background#run} does. */
  interface Worker {
    <T> void run(Background.Task<T> task, Consumer<T> then, Consumer<IOException> failed);
  }

  /**
   * A presenter that knows no tests yet.
   *
   * @param setup what is looked at from now on; empty where the program in front has no folder
   * @param dispatch takes what is told while tests run
   * @param seeds gives each run another one
   * @param covered whether it is counted what tests reach
   */
  TestsPresenter(
      Supplier<Optional<TestSetup>> setup,
      Worker worker,
      Executor dispatch,
      LongSupplier seeds,
      BooleanSupplier covered) {
    this.setup = setup;
    this.worker = worker;
    this.dispatch = dispatch;
    this.seeds = seeds;
    this.covered = covered;
  }

  /** Looks for tests. What runs of another folder is given up; of the same it goes on. */
  void look() {
    Optional<TestSetup> now = setup.get();
    if (!running() || other(now)) {
      begin(now, new TestJob.Wish(Set.of(), false, false, false));
    }
  }

  /** Runs all tests that are there by now. */
  void runAll() {
    if (!running()) {
      begin(setup.get(), new TestJob.Wish(Set.of(), true, covered.getAsBoolean(), false));
    }
  }

  /** Runs some tests. */
  void run(Set<TestId> chosen) {
    if (!running() && !chosen.isEmpty()) {
      begin(setup.get(), new TestJob.Wish(chosen, true, covered.getAsBoolean(), false));
    }
  }

  /** Runs a test that is compared with a recording, and records it anew. */
  void record(TestId test) {
    if (!running()) {
      begin(setup.get(), new TestJob.Wish(Set.of(test), true, false, true));
    }
  }

  /** Ends what runs: the tests that are under way count as not run. */
  void stop() {
    job.ifPresent(TestJob::stop);
    changes++;
  }

  private boolean other(Optional<TestSetup> now) {
    return !now.map(each -> each.files().folder()).equals(folder());
  }

  private void begin(Optional<TestSetup> now, TestJob.Wish wish) {
    job.ifPresent(TestJob::stop);
    if (other(now)) {
      files = List.of();
      results.clear();
      curves.clear();
      last = Optional.empty();
      takeCoverage(Optional.empty());
    }
    waiting.clear();
    trouble = "";
    done = 0;
    shown = now;
    job = shown.map(of -> new TestJob(of, wish, seeds.getAsLong()));
    changes++;
    job.ifPresent(
        started ->
            worker.run(
                () -> started.work(new Heard(started)),
                result -> finished(started, result),
                why -> failed(started, why)));
  }

  /** Hears of a job in its thread, and says it here unless another one has begun. */
  private final class Heard implements TestJob.Listener {
    private final TestJob of;

    Heard(TestJob of) {
      this.of = of;
    }

    @Override
    public void found(List<FoundFile> found) {
      dispatch.execute(
          () -> {
            if (isCurrent(of)) {
              take(of, found);
            }
          });
    }

    @Override
    public void ended(TestResult result) {
      dispatch.execute(
          () -> {
            if (isCurrent(of)) {
              results.put(result.id(), result);
              curves.remove(result.id());
              of.difference(result.id()).ifPresent(each -> curves.put(result.id(), each));
              waiting.remove(result.id());
              done++;
              changes++;
            }
          });
    }
  }

  private boolean isCurrent(TestJob one) {
    return job.filter(each -> each == one).isPresent();
  }

  private void take(TestJob of, List<FoundFile> found) {
    if (of.all()) {
      files = List.copyOf(found);
    } else {
      Map<String, FoundFile> byName = new TreeMap<>();
      files.forEach(each -> byName.put(each.name(), each));
      found.forEach(each -> byName.put(each.name(), each));
      files = List.copyOf(byName.values());
    }
    Set<TestId> there = new HashSet<>();
    files.forEach(file -> file.tests().forEach(test -> there.add(test.id())));
    results.keySet().retainAll(there);
    curves.keySet().retainAll(there);
    if (of.runs()) {
      waiting.addAll(there);
      waiting.removeIf(each -> !of.wants(each));
    }
    changes++;
  }

  private void finished(TestJob of, Optional<TestJob.Outcome> outcome) {
    if (isCurrent(of)) {
      job = Optional.empty();
      waiting.clear();
      outcome.ifPresent(
          each -> {
            last = Optional.of(each.result());
            takeCoverage(each.coverage());
          });
      changes++;
    }
  }

  private void failed(TestJob of, IOException why) {
    if (isCurrent(of)) {
      job = Optional.empty();
      waiting.clear();
      trouble = why.getMessage();
      changes++;
    }
  }

  /** Grows with every change of what is to be seen. */
  long changes() {
    return changes;
  }

  /** The files of tests. */
  List<FoundFile> files() {
    return files;
  }

  /** The folder that is looked at, for people. */
  Optional<String> folder() {
    return shown.map(each -> each.files().folder());
  }

  /** Whether a file belongs to what is shown: one of tests, or one that they have read. */
  boolean knows(String name) {
    return files.stream().anyMatch(each -> each.name().equals(name))
        || shown.filter(each -> each.files().hasRead(name)).isPresent();
  }

  /** Whether tests run now. */
  boolean running() {
    return job.filter(TestJob::runs).isPresent();
  }

  /** Whether people have asked it to stop, and it has not yet. */
  boolean stopping() {
    return running() && job.filter(TestJob::stopped).isPresent();
  }

  /** Whether tests are looked for now. */
  boolean looking() {
    return job.filter(each -> !each.runs()).isPresent();
  }

  /** Whether tests can run now. */
  boolean canRun() {
    return !running() && shown.isPresent();
  }

  /** Why tests could not be found; empty where they could. */
  String trouble() {
    return Messages.shown(trouble);
  }

  /** How many tests of this run have ended. */
  int done() {
    return done;
  }

  /** How many of this run are still to end. */
  int toDo() {
    return waiting.size();
  }

  /** What came of the last run. */
  Optional<SuiteResult> last() {
    return last;
  }

  /** What the last run has reached of programs; empty where that is not wanted, or not known. */
  Optional<CoverageReport> coverage() {
    return coverage.filter(_ -> covered.getAsBoolean());
  }

  /** What the last run has reached of a file, by its path. */
  Optional<CoverStrip.Reached> reached(Path file) {
    return Optional.ofNullable(reached.get(file));
  }

  private void takeCoverage(Optional<CoverageReport> report) {
    coverage = report;
    reached.clear();
    if (report.isPresent()) {
      Path folder = Path.of(shown.orElseThrow().files().folder());
      int tests = report.get().tests().size();
      for (FileCoverage each : report.get().files()) {
        reached.put(folder.resolve(each.file()).normalize(), new CoverStrip.Reached(each, tests));
      }
    }
  }

  /** What differed first when a test was compared with its recording, if that has a curve. */
  Optional<TrackCurves> difference(TestId id) {
    return Optional.ofNullable(curves.get(id));
  }

  /** The files and the robot of tests as they are now. */
  Optional<TestSetup> setup() {
    return setup.get();
  }

  /** A test ran somewhere else. */
  void ran(TestResult result) {
    results.put(result.id(), result);
    curves.remove(result.id());
    changes++;
  }

  /** What came of a test when it ran last. */
  Optional<TestResult> result(TestId id) {
    return Optional.ofNullable(results.get(id));
  }

  /** What the tree says of a test. */
  TestMark mark(TestId id) {
    return waiting.contains(id)
        ? TestMark.WAITING
        : result(id).map(each -> TestMark.of(each.status())).orElse(TestMark.NEW);
  }

  /** What the tree says of a file: the worst of it, as far as that is known. */
  TestMark mark(FoundFile file) {
    Set<TestMark> marks = new HashSet<>();
    file.tests().forEach(each -> marks.add(mark(each.id())));
    if (!file.problems().isEmpty()) {
      marks.add(TestMark.RED);
    }
    for (TestMark each :
        List.of(TestMark.RED, TestMark.WAITING, TestMark.NEW, TestMark.PASSED, TestMark.SKIPPED)) {
      if (marks.contains(each)) {
        return each;
      }
    }
    return TestMark.NEW;
  }

  /** The first test that is red. */
  Optional<TestId> firstRed() {
    return files.stream()
        .flatMap(file -> file.tests().stream())
        .map(TestCase::id)
        .filter(each -> mark(each) == TestMark.RED)
        .findFirst();
  }

  /** Where people want to go from a test: where it fails, or else its definition. */
  TestPlace target(TestCase test) {
    List<TestPlace> places = new ArrayList<>();
    result(test.id())
        .flatMap(TestResult::failure)
        .ifPresent(
            failure -> {
              failure.place().ifPresent(places::add);
              places.addAll(failure.stack());
            });
    // the script of a tree is no file
    return places.stream()
        .filter(each -> shown.filter(of -> of.files().hasRead(each.file())).isPresent())
        .findFirst()
        .orElse(test.place());
  }
}
