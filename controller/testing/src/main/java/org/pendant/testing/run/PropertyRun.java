package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.pendant.controller.bench.Choices;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.source.TestCase;

/**
 * Property run: a test that is run with many values, each time in a controller of its own. Where a
 * run is red, simpler values are looked for with which it is red as well, and these are reported.
 */
final class PropertyRun {
  /** Most runs that are made to find simpler values. */
  static final int MAX_SIMPLER = 300;

  private final TestCase test;
  private final TestCase.Property property;
  private final TestSettings settings;
  private final int mostSimpler;
  private final Function<Choices, TestResult> once;
  private final Consumer<List<Double>> reported;
  private final long stopNs;
  private double robotTimeS;
  private double wallTimeS;

  /**
   * A test and its runs.
   *
   * @param once runs it once
   * @param reported takes the choices of the red run that is reported
   */
  PropertyRun(
      TestCase test,
      TestCase.Property property,
      TestSettings settings,
      int mostSimpler,
      Function<Choices, TestResult> once,
      Consumer<List<Double>> reported) {
    this.test = test;
    this.property = property;
    this.settings = settings;
    this.mostSimpler = mostSimpler;
    this.once = once;
    this.reported = reported;
    stopNs = System.nanoTime() + settings.wallTimeout().toNanos();
  }

  /** A run that was red, and what it was made from. */
  private record Red(TestResult result, Choices choices) {
    String code() {
      return result.failure().orElseThrow().code();
    }
  }

  /** Runs it. */
  TestResult run() {
    Optional<TestResult> last = Optional.empty();
    for (int i = 0; i < property.runs(); i++) {
      if (System.nanoTime() > stopNs) {
        return late(i);
      }
      Choices choices = choices(i);
      TestResult result = run(choices);
      if (result.status().red()) {
        return told(simplest(new Red(result, choices)), i + 1);
      }
      if (result.status() == TestStatus.PASSED || last.isEmpty()) {
        last = Optional.of(result);
      }
    }
    // skipped where every run was
    return with(last.orElseThrow(), last.get().failure(), last.get().status());
  }

  private Choices choices(int run) {
    List<Double> first =
        run < property.examples().size() ? property.examples().get(run) : List.of();
    return new Choices(
        first, OptionalLong.of((settings.seed() * 31 + test.id().hashCode()) * 31 + run));
  }

  private TestResult run(Choices choices) {
    TestResult result = once.apply(choices);
    robotTimeS += result.robotTimeS();
    wallTimeS += result.wallTimeS();
    return result;
  }

  /** The red run of the simplest values that are found. */
  private Red simplest(Red first) {
    Red best = first;
    int left = mostSimpler;
    boolean better = true;
    while (better && left > 0) {
      better = false;
      for (List<Double> each : simpler(best.choices().made())) {
        if (left-- <= 0 || System.nanoTime() > stopNs) {
          return best;
        }
        Choices choices = new Choices(each, OptionalLong.empty());
        TestResult result = run(choices);
        if (result.status().red() && result.failure().orElseThrow().code().equals(best.code())) {
          best = new Red(result, choices);
          better = true;
          break;
        }
      }
    }
    return best;
  }

  /** Choices that are simpler, those that are much simpler first. */
  private static List<List<Double>> simpler(List<Double> choices) {
    List<List<Double>> all = new ArrayList<>();
    int needed = choices.size();
    while (needed > 0 && choices.get(needed - 1) == 0) {
      needed--;
    }
    List<Double> needs = choices.subList(0, needed);
    if (needed > 1) {
      all.add(List.copyOf(needs.subList(0, needed / 2)));
      all.add(List.copyOf(needs.subList(0, needed - 1)));
    }
    for (int i = 0; i < needed; i++) {
      double choice = needs.get(i);
      for (double each : simpler(choice)) {
        List<Double> changed = new ArrayList<>(needs);
        changed.set(i, each);
        all.add(List.copyOf(changed));
      }
    }
    return all;
  }

  /** Simpler choices than one: nearer to 0, on the other side of it, or with fewer digits. */
  private static List<Double> simpler(double choice) {
    List<Double> all = new ArrayList<>();
    if (choice == 0) {
      return all;
    }
    all.add(0.0);
    if (choice > 0.5) {
      all.add(0.5);
      all.add(choice - 0.5);
    }
    double base = choice > 0.5 ? 0.5 : 0;
    for (double share = 2; share <= 256; share *= 2) {
      all.add(choice - (choice - base) / share);
    }
    for (double steps = 4; steps <= 4096; steps *= 8) {
      all.add(Math.floor(choice * steps) / steps);
    }
    all.removeIf(each -> each >= choice);
    return all;
  }

  private TestResult told(Red red, int run) {
    TestFailure failure = red.result().failure().orElseThrow();
    List<String> values = red.choices().told();
    List<Double> made = new ArrayList<>(red.choices().made());
    while (!made.isEmpty() && made.getLast() == 0) {
      made.removeLast();
    }
    reported.accept(made);
    String paste = made.stream().map(Object::toString).collect(Collectors.joining(", "));
    String message =
        failure.message()
            + "\n"
            + (values.isEmpty()
                ? text("withNoValues")
                : text("withValues", String.join(", ", values)))
            + "\n"
            + text("foundInRun", run, property.runs(), paste.isEmpty() ? "0" : paste);
    return with(
        red.result(),
        Optional.of(new TestFailure(failure.code(), message, failure.place(), failure.stack())),
        red.result().status());
  }

  private TestResult late(int runs) {
    return new TestResult(
        test.id(),
        test.place(),
        test.tags(),
        TestStatus.TIMED_OUT,
        "",
        Optional.of(
            new TestFailure(
                "timed-out",
                text(
                    "lateAfterRuns",
                    runs,
                    property.runs(),
                    settings.wallTimeout().toMillis() / 1e3),
                Optional.of(test.place()),
                List.of())),
        robotTimeS,
        wallTimeS,
        List.of());
  }

  private TestResult with(TestResult result, Optional<TestFailure> failure, TestStatus status) {
    return new TestResult(
        result.id(),
        result.place(),
        result.tags(),
        status,
        result.skipped(),
        failure,
        robotTimeS,
        wallTimeS,
        result.output());
  }
}
