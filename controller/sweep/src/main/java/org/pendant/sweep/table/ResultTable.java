package org.pendant.sweep.table;

import static org.pendant.sweep.table.TableTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.pendant.models.arm.Joints;
import org.pendant.models.json.JsonValues;
import org.pendant.models.time.FrameTime;
import org.pendant.sweep.plan.ParameterRange;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.SweepParameter;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.run.JointLoads;
import org.pendant.sweep.run.SweepResult;

/**
 * Result table: the columns that the results of a plan have; docs/sweeps.md has them all. The
 * number first, then the parameters, then what came of them.
 */
public final class ResultTable {
  private final List<ResultColumn> columns;
  private final int parameters;

  private ResultTable(List<ResultColumn> columns, int parameters) {
    this.columns = List.copyOf(columns);
    this.parameters = parameters;
  }

  /** The table of a plan. */
  public static ResultTable of(SweepPlan plan) {
    List<ResultColumn> all = new ArrayList<>();
    all.add(ResultColumn.whole("run", text("variantNumber"), r -> r.variant().number()));
    for (int i = 0; i < plan.parameters().size(); i++) {
      all.add(parameter(plan.parameters().get(i), i));
    }
    outcome(all);
    joints(all, "torque", "Nm", text("driveTorque"), SweepResult::torque, true);
    joints(all, "speed", "rad/s", text("jointSpeed"), SweepResult::speed, true);
    joints(all, "current", "A", text("motorCurrent"), SweepResult::current, false);
    nearest(all);
    List<String> variables = plan.settings().variables();
    for (int i = 0; i < variables.size(); i++) {
      int place = i;
      all.add(
          new ResultColumn(
              "var_" + variables.get(i),
              CellType.TEXT,
              "",
              text("lastValue"),
              r ->
                  place < r.variables().size()
                      ? Optional.of(r.variables().get(place))
                      : Optional.empty()));
    }
    return new ResultTable(named(all), plan.parameters().size());
  }

  /** Each with a name of its own: one that is taken gets a number behind. */
  private static List<ResultColumn> named(List<ResultColumn> all) {
    Set<String> taken = new HashSet<>();
    List<ResultColumn> named = new ArrayList<>();
    for (ResultColumn each : all) {
      String name = each.name();
      for (int i = 2; !taken.add(name); i++) {
        name = each.name() + "_" + i;
      }
      named.add(
          new ResultColumn(name, each.type(), each.unit(), each.description(), each.getter()));
    }
    return named;
  }

  private static ResultColumn parameter(SweepParameter parameter, int place) {
    boolean numbers =
        switch (parameter.range()) {
          case ParameterRange.Between _ -> true;
          case ParameterRange.Listed(var values) ->
              values.stream().allMatch(ParameterValue::numeric);
        };
    String description = text("parameterValue");
    return numbers
        ? ResultColumn.number(
            parameter.name(), "", description, r -> r.variant().values().get(place).number())
        : ResultColumn.text(
            parameter.name(), description, r -> r.variant().values().get(place).text());
  }

  private static void outcome(List<ResultColumn> all) {
    all.add(ResultColumn.text("outcome", text("howEnded"), r -> r.outcome().word()));
    all.add(ResultColumn.text("reason", text("whyEnded"), SweepResult::reason));
    all.add(ResultColumn.whole("line", text("whereEnded"), r -> (long) r.line()));
    all.add(ResultColumn.number("duration", "s", text("robotTime"), SweepResult::durationS));
  }

  private static void joints(
      List<ResultColumn> all,
      String name,
      String unit,
      String what,
      Function<SweepResult, JointLoads> loads,
      boolean limited) {
    if (limited) {
      all.add(
          ResultColumn.number(
              name + "_share",
              "",
              text("largestShareOfAll", what),
              r -> largest(loads.apply(r).share())));
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      int joint = i;
      all.add(
          ResultColumn.number(
              name + "_peak_" + i,
              unit,
              text("largest", what),
              r -> loads.apply(r).peak().get(joint)));
      all.add(
          ResultColumn.number(
              name + "_rms_" + i, unit, text("rms", what), r -> loads.apply(r).rms().get(joint)));
      if (limited) {
        all.add(
            ResultColumn.number(
                name + "_share_" + i,
                "",
                text("largestShare", what),
                r -> loads.apply(r).share().get(joint)));
      }
    }
  }

  private static double largest(Joints shares) {
    double largest = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < Joints.COUNT; i++) {
      largest = Math.max(largest, shares.get(i));
    }
    return largest;
  }

  private static void nearest(List<ResultColumn> all) {
    all.add(
        ResultColumn.number("tool_speed", "m/s", text("toolSpeed"), SweepResult::toolSpeedMPerS));
    all.add(
        ResultColumn.number(
            "tool_speed_share", "", text("toolSpeedShare"), SweepResult::toolSpeedShare));
    all.add(
        ResultColumn.number("joint_limit", "rad", text("jointLimit"), SweepResult::jointLimitRad));
    all.add(ResultColumn.number("plane", "m", text("plane"), SweepResult::planeM));
    all.add(ResultColumn.number("singularity", "", text("singularity"), SweepResult::singularity));
    all.add(ResultColumn.number("force", "N", text("force"), SweepResult::forceN));
    all.add(ResultColumn.number("moment", "Nm", text("torque"), SweepResult::torqueNm));
    all.add(ResultColumn.number("energy", "J", text("energy"), SweepResult::energyJ));
    for (int i = 0; i < 3; i++) {
      int axis = i;
      all.add(
          ResultColumn.number(
              "end_" + "xyz".charAt(i), "m", text("end"), r -> r.endTcpInBase().get(axis)));
    }
    all.add(
        ResultColumn.text(
            "lines",
            text("lineTimes"),
            r ->
                r.lines().stream()
                    .map(
                        each ->
                            "\""
                                + each.line()
                                + "\":"
                                + JsonValues.number(each.frames() * 2 / 1000.0))
                    .collect(Collectors.joining(",", "{", "}"))));
    all.add(
        ResultColumn.text(
            "outputs",
            text("outputs"),
            r ->
                r.outputs().stream()
                    .map(
                        each ->
                            "["
                                + JsonValues.text(each.signal())
                                + ","
                                + each.level()
                                + ","
                                + JsonValues.number(
                                    Math.round(each.timeS() / FrameTime.FRAME_S) * 2 / 1000.0)
                                + "]")
                    .collect(Collectors.joining(",", "[", "]"))));
    all.add(ResultColumn.text("digest", text("digest"), r -> String.format("%016x", r.digest())));
  }

  /** In their order. */
  public List<ResultColumn> columns() {
    return columns;
  }

  /** The columns of the parameters. */
  public List<ResultColumn> parameterColumns() {
    return columns.subList(1, 1 + parameters);
  }

  /** What a result has in each column. */
  public List<Optional<Object>> row(SweepResult result) {
    return columns.stream().map(each -> each.getter().apply(result)).toList();
  }
}
