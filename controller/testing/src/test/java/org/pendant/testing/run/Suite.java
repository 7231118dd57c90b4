package org.pendant.testing.run;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Drive;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.state.ControllerState;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestResult;
import org.pendant.testing.coverage.CoverageCollector;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.source.TestSources;

/** A suite of tests in memory. */
final class Suite {
  private final Map<String, String> files = new HashMap<>();
  private Optional<CoverageCollector> coverage = Optional.empty();
  private Goldens goldens = Goldens.NONE;
  private TestSettings settings =
      new TestSettings(
          ControllerOptions.headless().withArm(ArmChoice.IDEAL),
          1,
          1,
          60,
          Duration.ofSeconds(60),
          false);

  /** A suite with a file of tests, {@code cell/pick_test.script}. */
  static Suite of(String... lines) {
    return new Suite().with("cell/pick_test.script", lines);
  }

  /** With one more file. */
  Suite with(String name, String... lines) {
    files.put(name, String.join("\n", lines) + "\n");
    return this;
  }

  /** With other settings. */
  Suite with(TestSettings other) {
    settings = other;
    return this;
  }

  /** With something that marked tests are compared with. */
  Suite with(Goldens other) {
    goldens = other;
    return this;
  }

  /** What its tests reach of programs. */
  CoverageReport coverage() {
    CoverageCollector collector = new CoverageCollector();
    coverage = Optional.of(collector);
    run();
    return collector.report();
  }

  /** The settings that it has. */
  TestSettings settings() {
    return settings;
  }

  /** Its first test, for a debugger. */
  DebuggedTest debugged() throws DebuggedTest.NotDebugged {
    TestRunner runner = runner();
    TestPlan plan = runner.plan(names());
    return runner.debug(plan, plan.tests().getFirst().id());
  }

  /** What comes of it where people end it in the first frame of a test that is marked. */
  SuiteResult stopped() {
    AtomicReference<TestRunner> runner = new AtomicReference<>();
    goldens =
        test ->
            new Goldens.Run() {
              @Override
              public void begins(Drive drive) {
                runner.get().stop();
              }

              @Override
              public void sees(ControllerState state) {}

              @Override
              public Optional<Goldens.Problem> passed() {
                return Optional.empty();
              }

              @Override
              public void close() {}
            };
    runner.set(runner());
    return runner.get().run(runner.get().plan(names()));
  }

  private TestRunner runner() {
    TestSources source =
        name -> {
          String text = files.get(name);
          if (text == null) {
            throw new IOException("no such file");
          }
          return text.getBytes(StandardCharsets.UTF_8);
        };
    return new TestRunner(source, settings, test -> true, result -> {}, goldens, coverage);
  }

  private List<String> names() {
    return files.keySet().stream().filter(each -> each.endsWith("_test.script")).sorted().toList();
  }

  /** What would be run. */
  TestPlan plan() {
    return runner().plan(names());
  }

  /** What comes of it. */
  SuiteResult run() {
    TestRunner runner = runner();
    return runner.run(runner.plan(names()));
  }

  /** What comes of its only test. */
  TestResult only() {
    SuiteResult result = run();
    if (!result.broken().isEmpty()) {
      throw new AssertionError(result.broken().getFirst().problems());
    }
    return result.results().getFirst();
  }

  /** What is wrong with its only file. */
  List<String> problems() {
    return run().broken().getFirst().problems();
  }
}
