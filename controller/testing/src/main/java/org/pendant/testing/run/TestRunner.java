package org.pendant.testing.run;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Random;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Predicate;
import org.pendant.controller.bench.Choices;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.script.function.Builtins;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.FileWarnings;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestId;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.builtin.TestBuiltins;
import org.pendant.testing.coverage.CoverageCollector;
import org.pendant.testing.run.TestPlan.Chosen;
import org.pendant.testing.source.TestCase;
import org.pendant.testing.source.TestFile;
import org.pendant.testing.source.TestFileReader;
import org.pendant.testing.source.TestSources;

/**
 * Test runner: reads test files and runs the tests in them, several at once and in a random order
 * that its seed repeats. What a test does cannot depend on the others.
 */
public final class TestRunner {
  private final TestSources files;
  private final TestSettings settings;
  private final Predicate<TestCase> wanted;
  private final TestListener listener;
  private final Goldens goldens;
  private final Optional<CoverageCollector> coverage;
  private final Builtins<ControlBox> ofPrograms;
  private final Builtins<ControlBox> ofTests;
  private final Map<TestId, List<Double>> reported = new ConcurrentHashMap<>();
  private final AtomicBoolean cancelled;
  private final AtomicBoolean stopped;
  private final int mostSimpler;

  /**
   * A runner.
   *
   * @param files that tests are in
   * @param wanted which of the tests are run
   * @param listener is told what has come of each, by any thread but by one at a time
   * @param goldens what tests are compared with that ask for it
   * @param coverage takes what tests reach of programs; empty where nobody asks for it
   */
  public TestRunner(
      TestSources files,
      TestSettings settings,
      Predicate<TestCase> wanted,
      TestListener listener,
      Goldens goldens,
      Optional<CoverageCollector> coverage) {
    this.files = files;
    this.settings = settings;
    this.wanted = wanted;
    this.listener = listener;
    this.goldens = goldens;
    this.coverage = coverage;
    ofPrograms = StandardBuiltins.create();
    ofTests = TestBuiltins.create();
    cancelled = new AtomicBoolean();
    stopped = new AtomicBoolean();
    mostSimpler = PropertyRun.MAX_SIMPLER;
  }

  /** A runner that plans tests which call these functions, and runs none. */
  TestRunner(
      TestSources files,
      TestSettings settings,
      Predicate<TestCase> wanted,
      Builtins<ControlBox> ofTests) {
    this.files = files;
    this.settings = settings;
    this.wanted = wanted;
    this.ofTests = ofTests;
    listener = _ -> {};
    goldens = Goldens.NONE;
    coverage = Optional.empty();
    ofPrograms = StandardBuiltins.create();
    cancelled = new AtomicBoolean();
    stopped = new AtomicBoolean();
    mostSimpler = 0;
  }

  private TestRunner(TestRunner of, TestSources files) {
    this.files = files;
    settings = of.settings;
    wanted = of.wanted;
    listener = _ -> {};
    goldens = of.goldens;
    coverage = Optional.empty();
    ofPrograms = of.ofPrograms;
    ofTests = of.ofTests;
    cancelled = of.cancelled;
    stopped = of.stopped;
    mostSimpler = 0;
  }

  /**
   * A runner of the same tests of which nobody is told, in other files; cancelled with this one.
   */
  public TestRunner over(TestSources others) {
    return new TestRunner(this, others);
  }

  /** Is told about tests while they run. */
  @FunctionalInterface
  public interface TestListener {
    /** A test has ended. */
    void ended(TestResult result);
  }

  /** Ends the suite as soon as possible: no more test begins. */
  public void cancel() {
    cancelled.set(true);
  }

  /**
   * Ends the suite now: those tests that run are given up where they are, and count as not run; no
   * more test begins.
   */
  public void stop() {
    stopped.set(true);
    cancel();
  }

  /** Whether it is to end. */
  public boolean cancelled() {
    return cancelled.get();
  }

  /**
   * Reads test files, and chooses from their tests those that are wanted.
   *
   * @param names of the files, in the order of the report
   */
  public TestPlan plan(List<String> names) {
    TestFileReader reader = new TestFileReader(files, ofTests, coverage.isPresent());
    List<Chosen> chosen = new ArrayList<>();
    List<BrokenTestFile> broken = new ArrayList<>();
    List<FileWarnings> warnings = new ArrayList<>();
    for (String name : names) {
      try {
        TestFile file = reader.read(name);
        TestPrograms programs =
            new TestPrograms(
                file, files, ofPrograms, ofTests, coverage.isPresent(), settings.controller());
        if (!file.warnings().isEmpty()) {
          warnings.add(new FileWarnings(name, file.warnings()));
        }
        for (TestCase each : file.tests()) {
          if (wanted.test(each)) {
            chosen.add(new Chosen(file, programs, each));
          }
        }
      } catch (TestFileReader.Broken e) {
        broken.add(e.file());
      }
    }
    return new TestPlan(chosen, broken, warnings);
  }

  /** Runs what is planned. */
  public SuiteResult run(TestPlan plan) {
    long beganNs = System.nanoTime();
    List<Chosen> chosen = plan.chosen();
    AtomicReferenceArray<TestResult> results = new AtomicReferenceArray<>(chosen.size());
    List<Integer> order = new ArrayList<>();
    for (int i = 0; i < chosen.size(); i++) {
      order.add(i);
    }
    Collections.shuffle(order, new Random(settings.seed()));
    runAll(chosen, order, results);
    List<TestResult> done = new ArrayList<>();
    for (int i = 0; i < results.length(); i++) {
      if (results.get(i) != null) {
        done.add(results.get(i));
      }
    }
    return new SuiteResult(
        done,
        plan.broken(),
        plan.warnings(),
        settings.seed(),
        chosen.size() - done.size(),
        (System.nanoTime() - beganNs) * 1e-9);
  }

  private void runAll(
      List<Chosen> chosen, List<Integer> order, AtomicReferenceArray<TestResult> results) {
    int jobs = settings.failFast() ? 1 : Math.max(1, Math.min(settings.jobs(), order.size()));
    AtomicInteger next = new AtomicInteger();
    Runnable worker =
        () -> {
          for (int i = next.getAndIncrement(); i < order.size(); i = next.getAndIncrement()) {
            if (cancelled.get()) {
              return;
            }
            int which = order.get(i);
            TestResult result = run(chosen.get(which));
            if (stopped.get()) {
              return;
            }
            results.set(which, result);
            tell(result);
          }
        };
    try (ExecutorService workers = Executors.newFixedThreadPool(jobs)) {
      for (int i = 0; i < jobs; i++) {
        workers.execute(worker);
      }
    }
  }

  private synchronized void tell(TestResult result) {
    if (settings.failFast() && result.status().red()) {
      cancel();
    }
    listener.ended(result);
  }

  TestResult run(Chosen one) {
    TestCase test = one.test();
    if (test.skip().isPresent()) {
      return result(test, TestOutcome.skipped(test.skip().get()));
    }
    try {
      return test.property().isPresent()
          ? new PropertyRun(
                  test,
                  test.property().get(),
                  settings,
                  mostSimpler,
                  choices -> run(one, choices, coverage, TestObserver.NONE),
                  choices -> reported.put(test.id(), choices))
              .run()
          : compared(one);
    } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
      // our own mistake, or a test that takes all memory: the other tests still count
      return result(
          test,
          TestOutcome.red(
              TestStatus.ERROR,
              new TestFailure(
                  "internal-error", "internal error: " + e, Optional.of(test.place()), List.of())));
    }
  }

  /** Runs a test once, and compares it with its recording where it is marked so. */
  private TestResult compared(Chosen one) {
    TestCase test = one.test();
    if (test.golden().isEmpty()) {
      return run(one, choices(test), coverage, TestObserver.NONE);
    }
    try (Goldens.Run golden = goldens.begins(test)) {
      TestResult result = run(one, choices(test), coverage, golden);
      return result.status() == TestStatus.PASSED
          ? golden.passed().map(problem -> red(result, failure(one, problem))).orElse(result)
          : result;
    }
  }

  private static TestFailure failure(Chosen one, Goldens.Problem problem) {
    TestCase test = one.test();
    String node = "";
    TestPlace place = test.place();
    if (problem.line() > 0 && test.watches()) {
      node =
          one.programs().nodeAt(problem.program(), problem.line()).map(at -> at + ": ").orElse("");
      place = new TestPlace(problem.program(), problem.line(), 0, "");
    } else if (problem.line() > 0) {
      place = one.file().composition().placeOfLine(problem.line(), test.id().function());
    }
    return new TestFailure(problem.code(), node + problem.message(), Optional.of(place), List.of());
  }

  private static TestResult red(TestResult result, TestFailure failure) {
    return new TestResult(
        result.id(),
        result.place(),
        result.tags(),
        TestStatus.FAILED,
        "",
        Optional.of(failure),
        result.robotTimeS(),
        result.wallTimeS(),
        result.output());
  }

  /**
   * Runs a test of a plan once more, exactly as it ran before: of one with many values the run that
   * was reported.
   *
   * @param observer sees its frames
   * @throws IllegalArgumentException if the plan has no such test
   */
  public void repeat(TestPlan plan, TestId id, TestObserver observer) {
    Chosen one = chosen(plan, id);
    var _ = run(one, choices(one.test()), Optional.empty(), observer);
  }

  /**
   * Prepares a test of a plan for a debugger; nothing has run.
   *
   * @throws DebuggedTest.NotDebugged if the debugger cannot see what it runs
   * @throws IllegalArgumentException if the plan has no such test
   */
  public DebuggedTest debug(TestPlan plan, TestId id) throws DebuggedTest.NotDebugged {
    Chosen one = chosen(plan, id);
    return DebuggedTest.of(
        one, prepared(one, choices(one.test()), Optional.empty(), TestObserver.NONE));
  }

  private static Chosen chosen(TestPlan plan, TestId id) {
    return plan.chosen().stream()
        .filter(each -> each.test().id().equals(id))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("no test " + id + " is planned"));
  }

  private TestResult run(
      Chosen one, Choices choices, Optional<CoverageCollector> covers, TestObserver observer) {
    if (stopped.get()) {
      return result(one.test(), TestOutcome.STOPPED);
    }
    return prepared(one, choices, covers, observer).run();
  }

  private TestRun prepared(
      Chosen one, Choices choices, Optional<CoverageCollector> covers, TestObserver observer) {
    return new TestRun(
        one.file(),
        one.test(),
        one.programs(),
        ofTests,
        one.test().golden().isPresent() ? settings.withoutSeed() : settings,
        covers,
        choices,
        observer,
        stopped::get);
  }

  /** Those of the only run of a test, or of the one that was reported. */
  private Choices choices(TestCase test) {
    List<Double> given = reported.get(test.id());
    return given == null
        ? new Choices(List.of(), OptionalLong.of(seed(test)))
        : new Choices(given, OptionalLong.empty());
  }

  private long seed(TestCase test) {
    return test.golden().isPresent()
        ? test.id().name().hashCode()
        : settings.seed() * 31 + test.id().hashCode();
  }

  static TestResult result(TestCase test, TestOutcome outcome) {
    return new TestResult(
        test.id(),
        test.place(),
        test.tags(),
        outcome.status(),
        outcome.skipped(),
        outcome.failure(),
        0,
        0,
        List.of());
  }
}
