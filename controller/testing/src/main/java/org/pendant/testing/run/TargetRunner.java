package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Predicate;
import org.pendant.controller.box.ControlBox;
import org.pendant.script.function.Builtins;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestResult;
import org.pendant.testing.builtin.TargetBuiltins;
import org.pendant.testing.builtin.TargetLimits;
import org.pendant.testing.remote.TargetTrouble;
import org.pendant.testing.remote.TargetView;
import org.pendant.testing.remote.TestTarget;
import org.pendant.testing.run.TestPlan.Chosen;
import org.pendant.testing.run.TestRunner.TestListener;
import org.pendant.testing.source.SentAssertions;
import org.pendant.testing.source.TestCase;
import org.pendant.testing.source.TestSources;

/**
 * Target runner: runs tests whose programs run on a target, one at a time and in the order of the
 * report. A test that needs what cannot be done there is skipped before anything is started.
 */
public final class TargetRunner {
  private final TestSettings settings;
  private final TestListener listener;
  private final TargetView view = new TargetView();
  private final Builtins<ControlBox> builtins = TargetBuiltins.create(view);
  private final TestRunner planner;
  private final AtomicBoolean cancelled = new AtomicBoolean();

  /**
   * A runner.
   *
   * @param files that tests are in
   * @param settings of which the number of jobs does not count
   * @param wanted which of the tests are run
   * @param listener is told what has come of each
   */
  public TargetRunner(
      TestSources files, TestSettings settings, Predicate<TestCase> wanted, TestListener listener) {
    this.settings = settings;
    this.listener = listener;
    planner = new TestRunner(files, settings, wanted, builtins);
  }

  /** As {@link TestRunner#plan}. */
  public TestPlan plan(List<String> names) {
    return planner.plan(names);
  }

  /** Ends the suite as soon as possible: no more test begins. */
  public void cancel() {
    cancelled.set(true);
  }

  /** Why a test of a plan cannot be run at a target, or is not to be run at all. */
  private Optional<String> skip(Chosen one) {
    TestCase test = one.test();
    if (test.skip().isPresent()) {
      return test.skip();
    }
    if (test.property().isPresent()) {
      return Optional.of(text("givenAtTarget"));
    }
    if (test.golden().isPresent()) {
      return Optional.of(text("goldenAtTarget"));
    }
    if (test.startRad().isPresent()) {
      return Optional.of(text("startAtTarget"));
    }
    if (test.scene().isPresent()) {
      return Optional.of(text("sceneAtTarget"));
    }
    return calls(one).stream()
        .flatMap(
            each ->
                (test.watches()
                        ? TargetLimits.reason(builtins, each)
                        : TargetLimits.reasonSent(builtins, each, SentAssertions.names()))
                    .stream())
        .findFirst()
        .map(why -> "--target: " + why);
  }

  private static List<String> calls(Chosen one) {
    return one.file().calls().getOrDefault(one.test().id().function(), List.of());
  }

  /** How many tests of a plan would run at a target. */
  public long count(TestPlan plan) {
    return plan.chosen().stream().filter(each -> skip(each).isEmpty()).count();
  }

  /** What comes of a plan of which nothing can run at a target. */
  public SuiteResult skipped(TestPlan plan) {
    List<TestResult> results = new ArrayList<>();
    for (Chosen each : plan.chosen()) {
      add(TestRunner.result(each.test(), TestOutcome.skipped(skip(each).orElseThrow())), results);
    }
    return result(plan, results, System.nanoTime());
  }

  /**
   * Runs what is planned. A target that is lost makes the test red that runs, and ends the suite.
   *
   * @param ready is told once that the target is ready, before anything moves
   * @throws TargetTrouble if nothing could be run, as the target is not ready
   */
  public SuiteResult run(TestPlan plan, TestTarget target, Runnable ready) throws TargetTrouble {
    long beganNs = System.nanoTime();
    Set<String> called = new LinkedHashSet<>();
    plan.chosen().stream()
        .filter(each -> skip(each).isEmpty())
        .forEach(each -> called.addAll(calls(each)));
    target.watch(TargetBuiltins.quantities(called));
    List<TestResult> results = new ArrayList<>();
    boolean begun = false;
    for (Chosen each : plan.chosen()) {
      if (cancelled.get()) {
        break;
      }
      Optional<String> skip = skip(each);
      if (skip.isPresent()) {
        add(TestRunner.result(each.test(), TestOutcome.skipped(skip.get())), results);
        continue;
      }
      TargetRun run = new TargetRun(each, settings, builtins, target, view, cancelled::get);
      try {
        run.begin();
        if (!begun) {
          begun = true;
          ready.run();
        }
        add(run.run(), results);
      } catch (TargetTrouble e) {
        if (!begun) {
          throw e;
        }
        cancel();
        add(run.lost(e), results);
      }
    }
    return result(plan, results, beganNs);
  }

  private void add(TestResult result, List<TestResult> results) {
    results.add(result);
    if (settings.failFast() && result.status().red()) {
      cancel();
    }
    listener.ended(result);
  }

  private SuiteResult result(TestPlan plan, List<TestResult> results, long beganNs) {
    return new SuiteResult(
        results,
        plan.broken(),
        plan.warnings(),
        settings.seed(),
        plan.chosen().size() - results.size(),
        (System.nanoTime() - beganNs) * 1e-9);
  }
}
