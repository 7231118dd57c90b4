package org.pendant.testing.run;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.testing.TestId;
import org.pendant.testing.TestResult;
import org.pendant.testing.run.TestPlan.Chosen;
import org.pendant.testing.source.TestCase;

/** Test trial: chosen tests, one after the other, until one of them is red. */
public final class TestTrial {
  /** How much longer than usual a test may take before it counts as one that does not end. */
  private static final double TIME_FACTOR = 3;

  /** And so much more, as a wait for something that never comes takes a while. */
  private static final double MORE_TIME_S = 5;

  private final TestRunner runner;
  private final Map<String, TestPlan> plans = new HashMap<>();

  /**
   * One test.
   *
   * @param usualS how much robot time it usually takes, in all its runs together
   */
  public record Step(TestId test, double usualS) {
    private Chosen limited(Chosen chosen) {
      int runs = chosen.test().property().map(TestCase.Property::runs).orElse(1);
      return chosen.within(usualS / runs * TIME_FACTOR + MORE_TIME_S);
    }
  }

  /** What comes of a trial. */
  public sealed interface Result {
    /** No test was red. */
    record Green() implements Result {}

    /** A test was red. */
    record Red(TestResult test) implements Result {}

    /** A file of tests, or the program that a test starts, does not compile. */
    record NoProgram(String why) implements Result {}
  }

  /**
   * A trial.
   *
   * @param runner of the files that are tried
   */
  public TestTrial(TestRunner runner) {
    this.runner = runner;
  }

  /** Runs tests in this order; only some of them where the runner is cancelled. */
  public Result run(List<Step> steps) {
    for (Step step : steps) {
      if (runner.cancelled()) {
        break;
      }
      String file = step.test().file();
      TestPlan plan = plans.computeIfAbsent(file, _ -> runner.plan(List.of(file)));
      if (!plan.broken().isEmpty()) {
        return new Result.NoProgram(plan.broken().getFirst().problems().getFirst());
      }
      for (Chosen each : plan.chosen()) {
        if (each.test().id().equals(step.test())) {
          TestResult result = runner.run(step.limited(each));
          if (result.status().red()) {
            return ofRed(result);
          }
        }
      }
    }
    return new Result.Green();
  }

  private static Result ofRed(TestResult result) {
    return result
        .failure()
        .filter(each -> each.code().equals(TestPrograms.NO_PROGRAM))
        .<Result>map(each -> new Result.NoProgram(each.message()))
        .orElse(new Result.Red(result));
  }
}
