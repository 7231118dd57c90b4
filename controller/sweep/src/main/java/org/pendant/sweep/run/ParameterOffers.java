package org.pendant.sweep.run;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.world.SceneObject;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Unit;
import org.pendant.language.syntax.Expression;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.sweep.plan.FrameAxis;
import org.pendant.sweep.plan.ParameterTarget;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.run.ParameterOffer.Group;

/**
 * Parameter offers: all that a plan could vary of a program, the robot that it runs on and the cell
 * around that, each with a range to begin with.
 */
public final class ParameterOffers {
  private static final int MAX_OFFERS = 2000;
  private static final double NEAR_M = 0.05;
  private static final double NEAR_RAD = 0.1;
  private static final List<String> POSE = List.of("m", "m", "m", "rad", "rad", "rad");
  private static final List<String> JOINTS = Collections.nCopies(Joints.COUNT, "rad");
  private static final Set<String> READS =
      Set.of(
          "get_digital_in",
          "get_standard_digital_in",
          "get_configurable_digital_in",
          "get_tool_digital_in");

  private final JobInputs inputs;
  private final ScriptPlaces places;
  private final List<ParameterOffer> offers = new ArrayList<>();

  private ParameterOffers(JobInputs inputs) {
    this.inputs = inputs;
    places =
        new ScriptPlaces(
            ScriptParser.parseProgram(inputs.program()).script(), StandardBuiltins.create());
  }

  /**
   * What could be varied.
   *
   * @param plan names program, robot, installation and scene; its parameters do not matter
   * @param folder from which the names in it are seen
   * @throws PlanException if one of the files cannot be read
   */
  public static List<ParameterOffer> of(SweepPlan plan, Path folder) throws PlanException {
    ParameterOffers found = new ParameterOffers(new PlanFiles(plan, folder).inputs());
    found.look();
    return found.offers.size() > MAX_OFFERS
        ? List.copyOf(found.offers.subList(0, MAX_OFFERS))
        : List.copyOf(found.offers);
  }

  private void look() {
    if (!places.moves().isEmpty()) {
      range(Group.MOVES, new ParameterTarget.MoveFactor("v"), "1", "", 0.5, 1.5);
      range(Group.MOVES, new ParameterTarget.MoveFactor("a"), "1", "", 0.5, 1.5);
    }
    places.variables().forEach(each -> variable(each, places.firstValue(each).orElseThrow()));
    places.moves().forEach(this::move);
    range(Group.LOAD, new ParameterTarget.Load(0), "", "kg", 0, 5);
    for (int i = 1; i <= 3; i++) {
      range(Group.LOAD, new ParameterTarget.Load(i), "", "m", -NEAR_M, NEAR_M);
    }
    for (FrameAxis axis : List.of(FrameAxis.X, FrameAxis.Y, FrameAxis.Z, FrameAxis.RZ)) {
      beside(Group.BASE, new ParameterTarget.BasePlace(axis), axis, 0.2, 0.5);
    }
    for (Feature each : inputs.installation().map(Installation::features).orElse(List.of())) {
      for (FrameAxis axis : FrameAxis.values()) {
        beside(
            Group.FEATURES,
            new ParameterTarget.FeaturePlace(each.name(), axis),
            axis,
            0.01,
            NEAR_RAD);
      }
    }
    for (SceneObject each : inputs.scene().objects()) {
      for (FrameAxis axis : FrameAxis.values()) {
        beside(
            Group.OBJECTS,
            new ParameterTarget.ObjectPlace(each.name(), axis),
            axis,
            0.01,
            NEAR_RAD);
      }
    }
    inputsRead()
        .forEach(
            signal -> {
              list(Group.INPUTS, new ParameterTarget.InputLevel(signal), "false", "false, true");
              range(Group.INPUTS, new ParameterTarget.InputTime(signal), "", "s", 0, 5);
            });
    range(Group.ROBOT, new ParameterTarget.Slider(), "1", "", 0.2, 1);
    range(Group.ROBOT, new ParameterTarget.Seed(), "0", "", 0, 9);
    list(Group.ROBOT, new ParameterTarget.RobotModel(), inputs.robot(), otherArms());
  }

  /** The arm with those that are one size smaller and larger. */
  private String otherArms() {
    List<String> ids = ArmLibrary.ids();
    int place = ids.indexOf(ArmLibrary.find(inputs.robot()).orElse(""));
    return place < 0
        ? inputs.robot()
        : String.join(", ", ids.subList(Math.max(0, place - 1), Math.min(ids.size(), place + 2)));
  }

  private void variable(String name, Expression value) {
    ParameterTarget whole = new ParameterTarget.Variable(name, OptionalInt.empty());
    if (value instanceof Expression.IntLiteral(var count, var _)) {
      // the number of an output, or of parts: what lies between is none
      list(
          Group.VARIABLES,
          whole,
          text(value),
          (count > 0 ? count - 1 + ", " : "") + count + ", " + (count + 1));
      return;
    }
    Optional<Double> number = number(value);
    if (number.isPresent()) {
      around(Group.VARIABLES, whole, text(value), number.get(), "");
      return;
    }
    switch (value) {
      case Expression.BoolLiteral _ -> list(Group.VARIABLES, whole, text(value), "True, False");
      case Expression.PoseLiteral(var elements, var _) -> elements(name, elements, POSE);
      case Expression.ListLiteral(var elements, var _) ->
          elements(name, elements, elements.size() == Joints.COUNT ? JOINTS : List.of());
      default -> list(Group.VARIABLES, whole, text(value), text(value));
    }
  }

  private void elements(String name, List<Expression> elements, List<String> units) {
    for (int i = 0; i < elements.size(); i++) {
      Optional<Double> number = number(elements.get(i));
      if (number.isPresent()) {
        String unit = i < units.size() ? units.get(i) : "";
        around(
            Group.VARIABLES,
            new ParameterTarget.Variable(name, OptionalInt.of(i)),
            text(elements.get(i)),
            number.get(),
            unit);
      }
    }
  }

  /** What a move gives as a number itself. */
  private void move(Expression.Call call) {
    int line = inputs.program().line(call.range().start());
    boolean first = places.callIn(line).filter(call::equals).isPresent();
    for (String name : List.of("v", "a", "t", "r")) {
      Optional<Parameter> parameter = places.parameter(call, name);
      Optional<Expression> given = parameter.flatMap(each -> places.given(call, each));
      Optional<Double> number = given.flatMap(ParameterOffers::number);
      if (first && number.isPresent()) {
        Unit unit = parameter.orElseThrow().unit();
        around(
            Group.MOVES,
            new ParameterTarget.CallArgument(line, name),
            text(given.orElseThrow()),
            number.get(),
            unit.symbol());
      }
    }
  }

  private Set<String> inputsRead() {
    Set<String> signals = new TreeSet<>();
    for (Expression.Call each : places.calls()) {
      if (READS.contains(each.function())
          && each.arguments().size() == 1
          && each.arguments().getFirst().value() instanceof Expression.IntLiteral(var i, var _)
          && i >= 0) {
        SignalBank bank = bank(each.function());
        if (i < bank.size()) {
          signals.add(bank.text() + "[" + i + "]");
        }
      }
    }
    return signals;
  }

  private static SignalBank bank(String function) {
    return function.contains("configurable")
        ? SignalBank.CONFIGURABLE_IN
        : function.contains("tool") ? SignalBank.TOOL_IN : SignalBank.STANDARD_IN;
  }

  /** A number, also one with a sign. */
  private static Optional<Double> number(Expression value) {
    return switch (value) {
      case Expression.IntLiteral(var number, var _) -> Optional.of((double) number);
      case Expression.FloatLiteral(var number, var _) -> Optional.of(number);
      case Expression.Unary(var operator, var operand, var _)
          when operator == Expression.UnaryOperator.NEGATE ->
          number(operand).map(each -> -each);
      default -> Optional.empty();
    };
  }

  private String text(Expression value) {
    return inputs.program().text(value.range()).strip();
  }

  /** Some place beside where it is now. */
  private void beside(
      Group group, ParameterTarget target, FrameAxis axis, double byM, double byRad) {
    boolean turns = axis.ordinal() >= 3;
    double by = turns ? byRad : byM;
    range(group, target, "0", turns ? "rad" : "m", -by, by);
  }

  /** Half as much to half as much again; of a length or angle a little less and more. */
  private void around(Group group, ParameterTarget target, String now, double number, String unit) {
    double by = number == 0 ? 1 : Math.abs(number) / 2;
    if (target instanceof ParameterTarget.Variable) {
      by = unit.equals("m") ? NEAR_M : unit.equals("rad") ? NEAR_RAD : by;
    }
    range(group, target, now, unit, number - by, number + by);
  }

  private void range(
      Group group, ParameterTarget target, String now, String unit, double from, double to) {
    offers.add(new ParameterOffer(group, target, now, unit, brief(from), brief(to), ""));
  }

  private static String brief(double number) {
    // without what binary fractions add: 0.1 + 0.05 is 0.15
    String text = ParameterValue.of(Math.rint(number * 1e9) / 1e9).text();
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }

  private void list(Group group, ParameterTarget target, String now, String values) {
    offers.add(new ParameterOffer(group, target, now, "", "", "", values));
  }
}
