package org.pendant.desktop.sweep;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.sweep.plan.RunSettings;
import org.pendant.sweep.plan.SamplingMethod;
import org.pendant.sweep.plan.SearchGoal;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.run.ParameterOffer;

/**
 * Plan draft: a plan as people edit it: texts that may be wrong.
 *
 * @param files what it is about
 * @param sampling which variants there are
 * @param settings what is the same for all
 * @param parameters all that could be varied, those that are among them
 */
record PlanDraft(Files files, Choice sampling, Settings settings, List<DraftParameter> parameters) {
  private static final String RUNS = "100";

  PlanDraft {
    parameters = List.copyOf(parameters);
  }

  /**
   * What a plan is about.
   *
   * @param plan its own file
   * @param program the file of the program
   * @param installation its file
   * @param scene its file
   * @param robot the arm by name; empty for that of installation or program
   */
  record Files(
      Path plan, Path program, Optional<Path> installation, Optional<Path> scene, String robot) {}

  /**
   * Which variants there are.
   *
   * @param method how they are chosen
   * @param runs how many
   * @param seed of what is random
   * @param column what a search makes small, or large
   * @param maximize whether large is good
   * @param limits what must hold of a run, one for each line or between semicolons
   * @param stall generations without a better run
   * @param population runs in each generation; empty for as many as is usual
   */
  record Choice(
      SamplingMethod method,
      String runs,
      String seed,
      String column,
      boolean maximize,
      String limits,
      String stall,
      String population) {
    Choice withMethod(SamplingMethod wanted) {
      return new Choice(wanted, runs, seed, column, maximize, limits, stall, population);
    }

    Choice withRuns(String text) {
      return new Choice(method, text, seed, column, maximize, limits, stall, population);
    }

    Choice withSeed(String text) {
      return new Choice(method, runs, text, column, maximize, limits, stall, population);
    }

    Choice withColumn(String text) {
      return new Choice(method, runs, seed, text, maximize, limits, stall, population);
    }

    Choice withMaximize(boolean on) {
      return new Choice(method, runs, seed, column, on, limits, stall, population);
    }

    Choice withLimits(String text) {
      return new Choice(method, runs, seed, column, maximize, text, stall, population);
    }

    Choice withStall(String text) {
      return new Choice(method, runs, seed, column, maximize, limits, text, population);
    }
  }

  /**
   * What is the same for all variants.
   *
   * @param timeLimit s
   * @param seed of random numbers and noise
   * @param idealArm an arm that is always on target
   * @param noise of sensors
   * @param startRamp of programs
   * @param variables names, with commas between
   * @param fixed names, with commas between
   * @param inputs {@code NAME=LEVEL}, with commas between
   */
  record Settings(
      String timeLimit,
      String seed,
      boolean idealArm,
      boolean noise,
      boolean startRamp,
      String variables,
      String fixed,
      String inputs) {
    Settings withTimeLimit(String text) {
      return new Settings(text, seed, idealArm, noise, startRamp, variables, fixed, inputs);
    }

    Settings withIdealArm(boolean on) {
      return new Settings(timeLimit, seed, on, noise, startRamp, variables, fixed, inputs);
    }

    Settings withNoise(boolean on) {
      return new Settings(timeLimit, seed, idealArm, on, startRamp, variables, fixed, inputs);
    }

    Settings withVariables(String text) {
      return new Settings(timeLimit, seed, idealArm, noise, startRamp, text, fixed, inputs);
    }

    Settings withFixed(String text) {
      return new Settings(timeLimit, seed, idealArm, noise, startRamp, variables, text, inputs);
    }

    Settings withInputs(String text) {
      return new Settings(timeLimit, seed, idealArm, noise, startRamp, variables, fixed, text);
    }
  }

  /** A grid of nothing yet, with usual settings. */
  static PlanDraft of(Files files) {
    return new PlanDraft(
        files,
        new Choice(
            SamplingMethod.GRID,
            RUNS,
            "0",
            "duration",
            false,
            "outcome == finished",
            Integer.toString(SearchGoal.STANDARD_STALL),
            ""),
        new Settings(brief(RunSettings.STANDARD_TIME_S), "0", false, false, true, "", "", ""),
        List.of());
  }

  /** A plan that was read; its parameters are those that it has. */
  static PlanDraft of(Files files, SweepPlan plan) {
    RunSettings run = plan.settings();
    PlanDraft usual = of(files);
    Choice sampling =
        new Choice(
            plan.sampling().method(),
            Long.toString(plan.sampling().runs()),
            Long.toString(plan.sampling().seed()),
            plan.search().map(SearchGoal::column).orElse(usual.sampling.column),
            plan.search().map(SearchGoal::maximize).orElse(false),
            plan.search()
                .map(goal -> String.join("; ", goal.limits()))
                .orElse(usual.sampling.limits),
            plan.search().map(goal -> Integer.toString(goal.stall())).orElse(usual.sampling.stall),
            plan.search()
                .filter(
                    goal ->
                        goal.population()
                            != SearchGoal.standardPopulation(plan.parameters().size()))
                .map(goal -> Integer.toString(goal.population()))
                .orElse(""));
    Settings settings =
        new Settings(
            brief(run.timeLimitS()),
            Long.toString(run.seed()),
            run.idealArm(),
            run.measuredNoise(),
            run.startRamp(),
            String.join(", ", run.variables()),
            String.join(", ", run.fixed()),
            String.join(", ", run.inputs()));
    return new PlanDraft(
        files, sampling, settings, plan.parameters().stream().map(DraftParameter::of).toList());
  }

  private static String brief(double number) {
    return number == Math.rint(number) ? Long.toString((long) number) : Double.toString(number);
  }

  /** The same with all that is offered; what people have chosen stays, and comes first. */
  PlanDraft offering(List<ParameterOffer> offers) {
    List<DraftParameter> all = new ArrayList<>();
    for (DraftParameter each : chosen()) {
      // what the program no longer has stays as long as it is chosen: the check tells
      all.add(
          offers.stream()
              .filter(offer -> offer.target().equals(each.target()))
              .findFirst()
              .map(each::offered)
              .orElse(each));
    }
    offers.stream()
        .map(DraftParameter::of)
        .filter(each -> all.stream().noneMatch(known -> known.target().equals(each.target())))
        .forEach(all::add);
    return withParameters(all);
  }

  /** Those that are varied. */
  List<DraftParameter> chosen() {
    return parameters.stream().filter(DraftParameter::chosen).toList();
  }

  PlanDraft withParameters(List<DraftParameter> next) {
    return new PlanDraft(files, sampling, settings, next);
  }

  PlanDraft withParameter(int place, DraftParameter next) {
    List<DraftParameter> all = new ArrayList<>(parameters);
    all.set(place, next);
    return withParameters(all);
  }

  PlanDraft with(Choice next) {
    return new PlanDraft(files, next, settings, parameters);
  }

  PlanDraft with(Settings next) {
    return new PlanDraft(files, sampling, next, parameters);
  }

  PlanDraft with(Files next) {
    return new PlanDraft(next, sampling, settings, parameters);
  }
}
