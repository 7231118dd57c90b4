package org.pendant.desktop.sweep;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Stream;
import org.pendant.desktop.sweep.DraftParameter.Part;
import org.pendant.kit.text.Messages;
import org.pendant.sweep.plan.ParameterRange;
import org.pendant.sweep.plan.ParameterTarget;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.PlanWriter;
import org.pendant.sweep.plan.RunSettings;
import org.pendant.sweep.plan.Sampling;
import org.pendant.sweep.plan.SamplingMethod;
import org.pendant.sweep.plan.SearchGoal;
import org.pendant.sweep.plan.SweepParameter;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.table.ResultTable;
import org.pendant.sweep.table.RowCondition;

/** Draft check: the plan that a draft means, or what is wrong with it, field by field. */
final class DraftCheck {
  /** Where a mistake belongs that no single field has. */
  static final String WHOLE = "plan";

  private static final int MAX_STEPS = 1_000_000;
  private static final int MAX_POPULATION = 10_000;
  private static final int MAX_STALL = 100_000;
  private static final long MAX_SEARCH = 1_000_000;

  private final PlanDraft draft;
  private final Map<String, String> errors = new LinkedHashMap<>();

  /**
   * What came of it.
   *
   * @param plan the plan; empty where something is wrong
   * @param text the file of the plan
   * @param errors what is wrong, by the name of the field, in the order of the form
   */
  record Outcome(Optional<SweepPlan> plan, String text, Map<String, String> errors) {}

  private DraftCheck(PlanDraft draft) {
    this.draft = draft;
  }

  static Outcome of(PlanDraft draft) {
    return new DraftCheck(draft).outcome();
  }

  /** What a draft is about, as a plan without parameters. */
  static SweepPlan bare(PlanDraft draft) {
    Path folder = draft.files().plan().toAbsolutePath().getParent();
    return new SweepPlan(
        draft.files().plan().toString(),
        seen(folder, draft.files().program()),
        Optional.of(draft.files().robot()).filter(each -> !each.isEmpty()),
        draft.files().installation().map(each -> seen(folder, each)),
        draft.files().scene().map(each -> seen(folder, each)),
        new RunSettings(
            RunSettings.STANDARD_TIME_S, 0, false, false, true, List.of(), List.of(), List.of()),
        new Sampling(SamplingMethod.GRID, 1, 0),
        List.of(),
        Optional.empty());
  }

  /** The name of the field for a part of a parameter. */
  static String field(ParameterTarget target, Part part) {
    return part + " " + target;
  }

  private void wrong(String field, String message) {
    errors.putIfAbsent(field, message);
  }

  private Outcome outcome() {
    PlanDraft.Choice choice = draft.sampling();
    List<SweepParameter> parameters = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (DraftParameter each : draft.chosen()) {
      if (each.name().isBlank()) {
        wrong(field(each.target(), Part.NAME), SweepTexts.text("columnWithoutName", each.title()));
      } else if (!names.add(each.name().strip())) {
        wrong(
            field(each.target(), Part.NAME),
            SweepTexts.text("twoColumnsOfOneName", each.name().strip()));
      }
      range(each)
          .map(range -> new SweepParameter(each.name().strip(), each.target(), range))
          .ifPresent(parameters::add);
    }
    if (draft.chosen().isEmpty()) {
      wrong(WHOLE, SweepTexts.text("nothingVaried"));
    }
    long runs = runs(parameters);
    long seed =
        whole(
            "sampling-seed",
            SweepTexts.text("seedOfSampling"),
            choice.seed(),
            Long.MIN_VALUE,
            Long.MAX_VALUE);
    Optional<SearchGoal> goal =
        choice.method() == SamplingMethod.SEARCH ? Optional.of(goal()) : Optional.empty();
    RunSettings settings = settings();
    if (!errors.isEmpty()) {
      return new Outcome(Optional.empty(), "", errors);
    }
    Path folder = draft.files().plan().toAbsolutePath().getParent();
    SweepPlan plan =
        new SweepPlan(
            draft.files().plan().toString(),
            seen(folder, draft.files().program()),
            Optional.of(draft.files().robot()).filter(each -> !each.isEmpty()),
            draft.files().installation().map(each -> seen(folder, each)),
            draft.files().scene().map(each -> seen(folder, each)),
            settings,
            new Sampling(choice.method(), runs, seed),
            parameters,
            goal);
    String text = PlanWriter.write(plan);
    goal.ifPresent(each -> checkGoal(each, plan));
    try {
      // the file is what counts: whatever else is wrong with it is told here as by the command
      SweepPlan read = PlanReader.read("plan", text);
      return new Outcome(errors.isEmpty() ? Optional.of(read) : Optional.empty(), text, errors);
    } catch (PlanException e) {
      wrong(WHOLE, e.reports().getFirst().replaceFirst("^plan:\\d+:\\d+: error: ", ""));
      return new Outcome(Optional.empty(), text, errors);
    }
  }

  /** A file as a plan in a folder names it. */
  private static String seen(Path folder, Path file) {
    Path whole = file.toAbsolutePath();
    Path root = whole.getRoot();
    return root != null && root.equals(folder.getRoot())
        ? folder.relativize(whole).toString().replace('\\', '/')
        : whole.toString();
  }

  private long whole(String field, String name, String text, long least, long most) {
    try {
      long number = Long.parseLong(text.strip());
      if (number >= least && number <= most) {
        return number;
      }
      wrong(field, SweepTexts.text("numberOutside", name, number, least, most));
    } catch (NumberFormatException e) {
      wrong(field, SweepTexts.text("notWhole", name, text.strip()));
    }
    return least;
  }

  private OptionalDouble number(String field, String name, String text) {
    try {
      double number = Double.parseDouble(text.strip().replace(',', '.'));
      if (Double.isFinite(number)) {
        return OptionalDouble.of(number);
      }
    } catch (NumberFormatException e) {
      // told below, as what is no finite number
    }
    wrong(
        field,
        text.isBlank()
            ? SweepTexts.text("emptyNotNumber", name)
            : SweepTexts.text("notNumber", name, text.strip()));
    return OptionalDouble.empty();
  }

  private Optional<ParameterRange> range(DraftParameter parameter) {
    if (!parameter.values().isBlank()) {
      if (draft.sampling().method() == SamplingMethod.SEARCH) {
        wrong(
            field(parameter.target(), Part.VALUES),
            SweepTexts.text("searchWithList", parameter.title()));
        return Optional.empty();
      }
      return listed(parameter);
    }
    if (parameter.target() instanceof ParameterTarget.RobotModel) {
      wrong(field(parameter.target(), Part.VALUES), SweepTexts.text("armNeedsList"));
      return Optional.empty();
    }
    String title = parameter.title();
    OptionalDouble from =
        number(
            field(parameter.target(), Part.FROM),
            SweepTexts.text("fromOf", title),
            parameter.from());
    OptionalDouble to = number(field(parameter.target(), Part.TO), title + ": to", parameter.to());
    int steps = 0;
    SamplingMethod method = draft.sampling().method();
    if (method == SamplingMethod.GRID || method == SamplingMethod.LIST) {
      steps =
          (int)
              whole(
                  field(parameter.target(), Part.STEPS),
                  SweepTexts.text("stepsOf", title),
                  parameter.steps(),
                  2,
                  MAX_STEPS);
    }
    if (from.isEmpty() || to.isEmpty()) {
      return Optional.empty();
    }
    if (!(from.getAsDouble() < to.getAsDouble())) {
      wrong(
          field(parameter.target(), Part.TO),
          SweepTexts.text("toBelowFrom", title, parameter.to().strip()));
      return Optional.empty();
    }
    return Optional.of(new ParameterRange.Between(from.getAsDouble(), to.getAsDouble(), steps));
  }

  private Optional<ParameterRange> listed(DraftParameter parameter) {
    List<ParameterValue> values = new ArrayList<>();
    for (String each : split(parameter.values())) {
      Optional<ParameterValue> value = value(each, parameter.target());
      if (value.isEmpty()) {
        wrong(
            field(parameter.target(), Part.VALUES),
            SweepTexts.text(
                parameter.target().whole() ? "listedNotWhole" : "listedNotNumber",
                parameter.title(),
                each));
        return Optional.empty();
      }
      values.add(value.get());
    }
    return Optional.of(new ParameterRange.Listed(values));
  }

  private static Optional<ParameterValue> value(String text, ParameterTarget target) {
    if (text.matches("[+-]?\\d{1,18}")) {
      return Optional.of(ParameterValue.of(Long.parseLong(text)));
    }
    try {
      double number = Double.parseDouble(text);
      if (!target.whole() && Double.isFinite(number)) {
        return Optional.of(ParameterValue.of(number));
      }
    } catch (NumberFormatException e) {
      // a word or an expression
    }
    if (target.numeric() || text.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        text.equalsIgnoreCase("true")
            ? ParameterValue.of("True")
            : text.equalsIgnoreCase("false")
                ? ParameterValue.of("False")
                : ParameterValue.of(text));
  }

  /** At commas, but not at those within brackets or quotes. */
  static List<String> split(String text) {
    List<String> parts = new ArrayList<>();
    StringBuilder part = new StringBuilder();
    int depth = 0;
    boolean quoted = false;
    for (char each : text.toCharArray()) {
      quoted ^= each == '"';
      if (!quoted) {
        depth += "[(".indexOf(each) >= 0 ? 1 : "])".indexOf(each) >= 0 ? -1 : 0;
      }
      if (each == ',' && depth <= 0 && !quoted) {
        parts.add(part.toString().strip());
        part.setLength(0);
      } else {
        part.append(each);
      }
    }
    parts.add(part.toString().strip());
    return parts;
  }

  private long runs(List<SweepParameter> parameters) {
    PlanDraft.Choice choice = draft.sampling();
    if (choice.method().counted()) {
      long most =
          choice.method() == SamplingMethod.SEARCH
              ? MAX_SEARCH
              : choice.method() == SamplingMethod.SOBOL ? Integer.MAX_VALUE : Sampling.MAX_RUNS;
      return whole(
          "runs",
          SweepTexts.text("numberOfRuns"),
          choice.runs(),
          1,
          Math.min(most, Sampling.MAX_RUNS));
    }
    long first = parameters.isEmpty() ? 0 : parameters.getFirst().gridSize();
    double runs = 1;
    for (SweepParameter each : parameters) {
      runs *= each.gridSize();
      if (choice.method() == SamplingMethod.LIST && each.gridSize() != first) {
        wrong(
            field(each.target(), Part.VALUES),
            SweepTexts.text(
                "listsOfOtherLengths",
                each.name(),
                each.gridSize(),
                first,
                parameters.getFirst().name()));
      }
    }
    if (choice.method() == SamplingMethod.LIST) {
      return first;
    }
    if (runs > Sampling.MAX_RUNS) {
      wrong(WHOLE, SweepTexts.text("gridTooLarge", Sampling.MAX_RUNS));
      return 1;
    }
    return (long) runs;
  }

  private SearchGoal goal() {
    PlanDraft.Choice choice = draft.sampling();
    if (choice.column().isBlank()) {
      wrong("goal", SweepTexts.text("searchNeedsColumn"));
    }
    int population =
        choice.population().isBlank()
            ? SearchGoal.standardPopulation(draft.chosen().size())
            : (int)
                whole(WHOLE, SweepTexts.text("population"), choice.population(), 4, MAX_POPULATION);
    return new SearchGoal(
        choice.column().strip(),
        choice.maximize(),
        parts(choice.limits(), "[;\n]"),
        population,
        (int) whole("stall", SweepTexts.text("generations"), choice.stall(), 1, MAX_STALL));
  }

  private void checkGoal(SearchGoal goal, SweepPlan plan) {
    ResultTable table = ResultTable.of(plan);
    if (table.columns().stream().noneMatch(each -> each.name().equals(goal.column()))) {
      wrong("goal", SweepTexts.text("noSuchColumn", goal.column()));
    }
    for (String each : goal.limits()) {
      try {
        RowCondition.parse(each, table.columns());
      } catch (IllegalArgumentException e) {
        wrong("limits", Messages.shown(e.getMessage()));
      }
    }
  }

  private RunSettings settings() {
    PlanDraft.Settings settings = draft.settings();
    OptionalDouble limitS =
        number("time-limit", SweepTexts.text("longestRun"), settings.timeLimit());
    if (limitS.isPresent()
        && !(limitS.getAsDouble() >= 0.002 && limitS.getAsDouble() <= RunSettings.MAX_TIME_S)) {
      wrong(
          "time-limit",
          SweepTexts.text(
              "longestRunOutside", settings.timeLimit().strip(), (long) RunSettings.MAX_TIME_S));
    }
    for (String each : parts(settings.inputs(), ",")) {
      if (!each.contains("=")) {
        wrong("inputs", SweepTexts.text("inputNotLevel", each));
      }
    }
    return new RunSettings(
        limitS.orElse(RunSettings.STANDARD_TIME_S),
        whole(
            WHOLE, SweepTexts.text("seedOfRuns"), settings.seed(), Long.MIN_VALUE, Long.MAX_VALUE),
        settings.idealArm(),
        settings.noise(),
        settings.startRamp(),
        parts(settings.variables(), ","),
        parts(settings.fixed(), ","),
        parts(settings.inputs(), ","));
  }

  private static List<String> parts(String text, String between) {
    return Stream.of(text.split(between))
        .map(String::strip)
        .filter(each -> !each.isEmpty())
        .toList();
  }
}
