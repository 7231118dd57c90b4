package org.pendant.sweep.plan;

import static org.pendant.sweep.plan.PlanTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.pendant.controller.io.SignalText;
import org.tomlj.Toml;
import org.tomlj.TomlParseResult;
import org.tomlj.TomlPosition;

/** Plan reader: reads a plan from TOML; docs/sweeps.md describes the file. */
public final class PlanReader {
  /** Bytes of a plan at most. */
  public static final int MAX_BYTES = 4 << 20;

  private static final int MAX_PARAMETERS = 200;
  private static final int MAX_NAMES = 1000;
  private static final long MAX_SEARCH = 1_000_000;

  private final List<String> mistakes = new ArrayList<>();
  private final TomlFields fields;
  private final String name;

  private PlanReader(String name, TomlParseResult toml) {
    this.name = name;
    fields = new TomlFields(name, toml, text("thePlan"), TomlPosition.positionAt(1, 1), mistakes);
  }

  /**
   * Reads a plan.
   *
   * @param name of the file, for messages
   * @throws PlanException with all that is wrong, each with line and column
   */
  public static SweepPlan read(String name, String text) throws PlanException {
    TomlParseResult toml = Toml.parse(text);
    if (toml.hasErrors()) {
      throw new PlanException(
          toml.errors().stream()
              .map(each -> TomlFields.report(name, each.position(), each.getMessage()))
              .toList());
    }
    PlanReader reader = new PlanReader(name, toml);
    Optional<SweepPlan> plan = reader.plan();
    if (plan.isEmpty() || !reader.mistakes.isEmpty()) {
      throw new PlanException(reader.mistakes);
    }
    return plan.get();
  }

  private Optional<SweepPlan> plan() {
    fields.allow(
        "program",
        "robot",
        "installation",
        "scene",
        "arm",
        "noise",
        "start_ramp",
        "seed",
        "time_limit",
        "variables",
        "fixed",
        "inputs",
        "sampling",
        "search",
        "parameter");
    Optional<String> program = fields.text("program", text("programFile"));
    if (program.isEmpty() && !fields.has("program")) {
      fields.wrong("program", text("programMissing"));
    }
    List<SweepParameter> parameters = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (TomlFields each : fields.allFields("parameter", MAX_PARAMETERS)) {
      parameter(each, names).ifPresent(parameters::add);
    }
    if (parameters.isEmpty() && mistakes.isEmpty()) {
      fields.wrong("parameter", text("parameterMissing"));
    }
    RunSettings settings = settings();
    Optional<String> robot = fields.text("robot", text("armOrFile"));
    Optional<String> installation = fields.text("installation", text("installationFile"));
    Optional<String> scene = fields.text("scene", text("sceneFile"));
    Optional<SearchGoal> search = fields.fields("search").flatMap(each -> search(each, parameters));
    Optional<Sampling> sampling = fields.has("search") ? searched(search) : sampling(parameters);
    return mistakes.isEmpty() && program.isPresent() && sampling.isPresent()
        ? Optional.of(
            new SweepPlan(
                name,
                program.get(),
                robot,
                installation,
                scene,
                settings,
                sampling.get(),
                parameters,
                search))
        : Optional.empty();
  }

  private RunSettings settings() {
    List<String> inputs = fields.texts("inputs", MAX_NAMES, text("inputTexts"));
    for (String each : inputs) {
      int equals = each.indexOf('=');
      if (equals < 0) {
        fields.wrong("inputs", text("wrongInput", each));
      } else {
        checkInput("inputs", each.substring(0, equals), each.substring(equals + 1), fields);
      }
    }
    return new RunSettings(
        fields
            .number("time_limit", 0.002, RunSettings.MAX_TIME_S, " s")
            .orElse(RunSettings.STANDARD_TIME_S),
        fields.whole("seed", Long.MIN_VALUE, Long.MAX_VALUE).orElse(0),
        choice("arm", "dynamic", "ideal"),
        choice("noise", "none", "measured"),
        fields.flag("start_ramp", true),
        fields.texts("variables", MAX_NAMES, text("variableNames")),
        fields.texts("fixed", MAX_NAMES, text("poseVariableNames")),
        inputs);
  }

  private static void checkInput(String key, String signal, String level, TomlFields at) {
    try {
      SignalText.input(signal, level);
    } catch (IllegalArgumentException e) {
      at.wrong(key, key + ": " + signal + "=" + level + ": " + e.getMessage());
    }
  }

  /** Whether a word is the other one, and not the standard one. */
  private boolean choice(String key, String standard, String other) {
    Optional<String> word = fields.text(key, '"' + standard + "\" or \"" + other + '"');
    if (word.isPresent() && !List.of(standard, other).contains(word.get())) {
      fields.wrong(key, text("wrongChoice", key, word.get(), standard, other));
    }
    return word.filter(other::equals).isPresent();
  }

  private Optional<Sampling> sampling(List<SweepParameter> parameters) {
    TomlFields given = fields.fields("sampling").orElse(null);
    if (given == null) {
      return sized(new Sampling(SamplingMethod.GRID, 0, 0), parameters, fields);
    }
    given.allow("method", "runs", "seed");
    String word = given.text("method", text("aMethod")).orElse(SamplingMethod.GRID.word());
    Optional<SamplingMethod> method = SamplingMethod.of(word);
    if (method.isEmpty()) {
      given.wrong("method", text("wrongMethod", word, String.join(", ", SamplingMethod.words())));
      return Optional.empty();
    }
    long most = method.get() == SamplingMethod.SOBOL ? Integer.MAX_VALUE : Sampling.MAX_RUNS;
    long runs = given.whole("runs", 1, Math.min(most, Sampling.MAX_RUNS)).orElse(0);
    if (method.get().counted() && runs == 0) {
      given.wrong("runs", text("runsMissing", word));
      return Optional.empty();
    }
    if (!method.get().counted() && given.has("runs")) {
      given.wrong("runs", text("runsWithout", word));
    }
    long seed = given.whole("seed", Long.MIN_VALUE, Long.MAX_VALUE).orElse(0);
    return sized(new Sampling(method.get(), runs, seed), parameters, given);
  }

  private static Optional<SearchGoal> search(TomlFields given, List<SweepParameter> parameters) {
    given.allow("minimize", "maximize", "limits", "runs", "population", "stall", "seed");
    Optional<String> least = given.text("minimize", text("resultColumn"));
    Optional<String> most = given.text("maximize", text("resultColumn"));
    if (least.isPresent() == most.isPresent()) {
      given.wrong("minimize", text("goalMissing"));
      return Optional.empty();
    }
    for (SweepParameter each : parameters) {
      if (!(each.range() instanceof ParameterRange.Between)) {
        given.wrong("minimize", text("searchedByValues", each.name()));
        return Optional.empty();
      }
    }
    return Optional.of(
        new SearchGoal(
            least.or(() -> most).orElseThrow(),
            most.isPresent(),
            given.texts("limits", MAX_NAMES, text("limitTexts")),
            (int)
                given
                    .whole("population", 4, 10_000)
                    .orElse(SearchGoal.standardPopulation(parameters.size())),
            (int) given.whole("stall", 1, 100_000).orElse(SearchGoal.STANDARD_STALL)));
  }

  private Optional<Sampling> searched(Optional<SearchGoal> goal) {
    if (fields.has("sampling")) {
      fields.wrong("sampling", text("samplingWithSearch"));
    }
    TomlFields given = fields.fields("search").orElse(null);
    if (given == null || goal.isEmpty()) {
      return Optional.empty();
    }
    long runs = given.whole("runs", 1, MAX_SEARCH).orElse(SearchGoal.STANDARD_RUNS);
    long seed = given.whole("seed", Long.MIN_VALUE, Long.MAX_VALUE).orElse(0);
    return Optional.of(new Sampling(SamplingMethod.SEARCH, runs, seed));
  }

  private static Optional<Sampling> sized(
      Sampling wanted, List<SweepParameter> parameters, TomlFields at) {
    if (wanted.method().counted()) {
      return Optional.of(wanted);
    }
    boolean list = wanted.method() == SamplingMethod.LIST;
    long runs = 1;
    for (SweepParameter each : parameters) {
      long size = each.gridSize();
      if (size < 1) {
        at.wrong("method", text("noSize", each.name(), wanted.method().word()));
        return Optional.empty();
      }
      if (list && parameters.getFirst().gridSize() != size) {
        at.wrong(
            "method",
            text(
                "otherSize",
                each.name(),
                size,
                parameters.getFirst().gridSize(),
                parameters.getFirst().name()));
        return Optional.empty();
      }
      runs = list ? size : runs * size;
      if (runs > Sampling.MAX_RUNS) {
        at.wrong("method", text("gridTooLarge", Sampling.MAX_RUNS));
        return Optional.empty();
      }
    }
    return Optional.of(new Sampling(wanted.method(), runs, wanted.seed()));
  }

  private static Optional<SweepParameter> parameter(TomlFields at, Set<String> names) {
    at.allow("name", "set", "from", "to", "steps", "values");
    Optional<String> set = at.text("set", TargetText.LEGAL);
    if (set.isEmpty()) {
      if (!at.has("set")) {
        at.wrong("set", text("setMissing", TargetText.LEGAL));
      }
      return Optional.empty();
    }
    Optional<ParameterTarget> target = TargetText.parse(set.get());
    if (target.isEmpty()) {
      at.wrong("set", text("wrongSet", set.get(), TargetText.LEGAL));
      return Optional.empty();
    }
    String name = at.text("name", text("aName")).orElse(set.get());
    if (!names.add(name)) {
      at.wrong("name", text("sameName", name));
    }
    Optional<ParameterRange> range =
        at.has("values") ? listed(at, target.get()) : between(at, target.get());
    return range.map(each -> new SweepParameter(name, target.get(), each));
  }

  private static Optional<ParameterRange> listed(TomlFields at, ParameterTarget target) {
    for (String key : List.of("from", "to", "steps")) {
      if (at.has(key)) {
        at.wrong(key, text("besideValues", key));
      }
    }
    List<ParameterValue> values = new ArrayList<>();
    for (Object each : at.array("values", 1_000_000, text("valueArray"))) {
      Optional<ParameterValue> value = value(each, target);
      if (value.isEmpty()) {
        at.wrong(
            "values",
            text(
                "wrongValues",
                TomlFields.shown(each),
                text(target.whole() ? "wholeNumbers" : target.numeric() ? "numbers" : "values")));
        return Optional.empty();
      }
      if (target instanceof ParameterTarget.InputLevel(var signal)) {
        checkInput("values", signal, value.get().text().toLowerCase(java.util.Locale.ROOT), at);
      }
      values.add(value.get());
    }
    if (values.isEmpty()) {
      at.wrong("values", text("valuesEmpty"));
      return Optional.empty();
    }
    return Optional.of(new ParameterRange.Listed(values));
  }

  private static Optional<ParameterValue> value(Object found, ParameterTarget target) {
    return switch (found) {
      case Long whole -> Optional.of(ParameterValue.of(whole.longValue()));
      case Double number when !target.whole() && Double.isFinite(number) ->
          Optional.of(ParameterValue.of(number.doubleValue()));
      case Boolean level when !target.numeric() ->
          Optional.of(ParameterValue.of(level ? "True" : "False"));
      case String text when !target.numeric() -> Optional.of(ParameterValue.of(text));
      default -> Optional.empty();
    };
  }

  private static Optional<ParameterRange> between(TomlFields at, ParameterTarget target) {
    double largest = Double.MAX_VALUE;
    OptionalDouble from = at.number("from", -largest, largest, "");
    OptionalDouble to = at.number("to", -largest, largest, "");
    if (from.isEmpty() || to.isEmpty()) {
      if (!at.has("from") || !at.has("to")) {
        at.wrong("set", text("valuesMissing"));
      }
      return Optional.empty();
    }
    if (target instanceof ParameterTarget.RobotModel) {
      at.wrong("from", text("robotByNumbers"));
      return Optional.empty();
    }
    if (!(from.getAsDouble() < to.getAsDouble())) {
      at.wrong("to", text("toBelowFrom", to.getAsDouble(), from.getAsDouble()));
      return Optional.empty();
    }
    long steps = at.whole("steps", 2, 1_000_000).orElse(0);
    return Optional.of(
        new ParameterRange.Between(from.getAsDouble(), to.getAsDouble(), (int) steps));
  }
}
