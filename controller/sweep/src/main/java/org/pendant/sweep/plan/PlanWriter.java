package org.pendant.sweep.plan;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Plan writer: writes a plan as the TOML that {@link PlanReader} reads as the same plan. What a
 * plan need not say, because it is so anyway, is left out.
 */
public final class PlanWriter {
  private final StringBuilder text = new StringBuilder();

  private PlanWriter() {}

  /** The text of a plan. */
  public static String write(SweepPlan plan) {
    PlanWriter writer = new PlanWriter();
    writer.put("program", plan.program());
    writer.put("robot", plan.robot());
    writer.put("installation", plan.installation());
    writer.put("scene", plan.scene());
    writer.settings(plan.settings());
    plan.search()
        .ifPresentOrElse(
            goal -> writer.search(goal, plan.sampling(), plan.parameters().size()),
            () -> writer.sampling(plan.sampling()));
    plan.parameters().forEach(writer::parameter);
    return writer.text.toString();
  }

  private void settings(RunSettings settings) {
    if (settings.idealArm()) {
      put("arm", "ideal");
    }
    if (settings.measuredNoise()) {
      put("noise", "measured");
    }
    if (!settings.startRamp()) {
      line("start_ramp", "false");
    }
    if (settings.seed() != 0) {
      line("seed", Long.toString(settings.seed()));
    }
    if (settings.timeLimitS() != RunSettings.STANDARD_TIME_S) {
      line("time_limit", number(settings.timeLimitS()));
    }
    put("inputs", settings.inputs());
    put("variables", settings.variables());
    put("fixed", settings.fixed());
  }

  private void sampling(Sampling sampling) {
    if (sampling.method() == SamplingMethod.GRID && sampling.seed() == 0) {
      return;
    }
    text.append("\n[sampling]\n");
    put("method", sampling.method().word());
    if (sampling.method().counted()) {
      line("runs", Long.toString(sampling.runs()));
    }
    if (sampling.seed() != 0) {
      line("seed", Long.toString(sampling.seed()));
    }
  }

  private void search(SearchGoal goal, Sampling sampling, int parameters) {
    text.append("\n[search]\n");
    put(goal.maximize() ? "maximize" : "minimize", goal.column());
    put("limits", goal.limits());
    line("runs", Long.toString(sampling.runs()));
    if (goal.population() != SearchGoal.standardPopulation(parameters)) {
      line("population", Integer.toString(goal.population()));
    }
    if (goal.stall() != SearchGoal.STANDARD_STALL) {
      line("stall", Integer.toString(goal.stall()));
    }
    if (sampling.seed() != 0) {
      line("seed", Long.toString(sampling.seed()));
    }
  }

  private void parameter(SweepParameter parameter) {
    text.append("\n[[parameter]]\n");
    String set = TargetText.of(parameter.target());
    if (!parameter.name().equals(set)) {
      put("name", parameter.name());
    }
    put("set", set);
    switch (parameter.range()) {
      case ParameterRange.Between(var from, var to, var steps) -> {
        line("from", number(from));
        line("to", number(to));
        if (steps > 0) {
          line("steps", Integer.toString(steps));
        }
      }
      case ParameterRange.Listed(var values) ->
          line(
              "values",
              values.stream()
                  .map(each -> value(each, parameter.target()))
                  .collect(Collectors.joining(", ", "[", "]")));
    }
  }

  private static String value(ParameterValue value, ParameterTarget target) {
    if (value.numeric()) {
      return value.text();
    }
    boolean level = value.text().equals("True") || value.text().equals("False");
    return level && !target.numeric()
        ? value.text().toLowerCase(Locale.ROOT)
        : quoted(value.text());
  }

  private static String number(double number) {
    String digits = Double.toString(number);
    return digits.endsWith(".0") ? digits.substring(0, digits.length() - 2) : digits;
  }

  private void put(String key, Optional<String> value) {
    value.ifPresent(each -> put(key, each));
  }

  private void put(String key, String value) {
    line(key, quoted(value));
  }

  private void put(String key, List<String> values) {
    if (!values.isEmpty()) {
      line(
          key, values.stream().map(PlanWriter::quoted).collect(Collectors.joining(", ", "[", "]")));
    }
  }

  private void line(String key, String value) {
    text.append(key).append(" = ").append(value).append('\n');
  }

  /** As a basic string of TOML 1.0. */
  private static String quoted(String value) {
    StringBuilder quoted = new StringBuilder("\"");
    for (int i = 0; i < value.length(); i++) {
      char each = value.charAt(i);
      if (each == '"' || each == '\\') {
        quoted.append('\\').append(each);
      } else if (each < ' ' || each == 0x7F) {
        quoted.append(String.format("\\u%04x", (int) each));
      } else {
        quoted.append(each);
      }
    }
    return quoted.append('"').toString();
  }
}
