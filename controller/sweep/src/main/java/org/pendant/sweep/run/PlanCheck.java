package org.pendant.sweep.run;

import static org.pendant.sweep.run.SweepRunTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.world.SceneObject;
import org.pendant.language.check.Nearest;
import org.pendant.language.syntax.Expression;
import org.pendant.sweep.plan.FrameAxis;
import org.pendant.sweep.plan.ParameterTarget;
import org.pendant.sweep.plan.SweepParameter;

/** Plan check: whether what the parameters of a plan change is there. */
final class PlanCheck {
  private static final Set<FrameAxis> OF_BASE =
      Set.of(FrameAxis.X, FrameAxis.Y, FrameAxis.Z, FrameAxis.RZ);

  private final JobInputs inputs;
  private final ScriptPlaces places;
  private final List<String> mistakes = new ArrayList<>();

  private PlanCheck(JobInputs inputs, ScriptPlaces places) {
    this.inputs = inputs;
    this.places = places;
  }

  /** What is wrong, for people. */
  static List<String> mistakes(JobInputs inputs, ScriptPlaces places) {
    PlanCheck check = new PlanCheck(inputs, places);
    inputs.plan().parameters().forEach(check::look);
    for (String each : inputs.plan().settings().fixed()) {
      check.variable("fixed", each);
    }
    return check.mistakes;
  }

  private void wrong(String what, String message) {
    mistakes.add(inputs.plan().name() + ": error: " + what + ": " + message);
  }

  /** A complaint about a name, with the name that may be meant. */
  private static String near(
      String complaint, String name, Supplier<? extends Iterable<String>> among) {
    List<String> names = new ArrayList<>();
    among.get().forEach(names::add);
    return new Nearest()
        .to(name, () -> names)
        .map(each -> text("didYouMean", complaint, each))
        .orElse(complaint);
  }

  private void look(SweepParameter parameter) {
    String name = parameter.name();
    switch (parameter.target()) {
      case ParameterTarget.Variable variable -> {
        if (variable(name, variable.name())
            && variable.element().isPresent()
            && places.firstElement(variable.name(), variable.element().getAsInt()).isEmpty()) {
          wrong(name, text("noSuchElement", variable.name(), variable.element().getAsInt()));
        }
      }
      case ParameterTarget.CallArgument(var line, var argument) -> call(name, line, argument);
      case ParameterTarget.MoveFactor _ -> {
        if (places.moves().isEmpty()) {
          wrong(name, text("noMoves"));
        }
      }
      case ParameterTarget.BasePlace(var axis) -> base(name, axis);
      case ParameterTarget.FeaturePlace(var feature, var _) -> feature(name, feature);
      case ParameterTarget.ObjectPlace(var object, var _) -> {
        List<String> names = inputs.scene().objects().stream().map(SceneObject::name).toList();
        if (!names.contains(object)) {
          wrong(name, near(text("noObject", object), object, () -> names));
        }
      }
      case ParameterTarget.Slider _,
          ParameterTarget.Load _,
          ParameterTarget.InputLevel _,
          ParameterTarget.InputTime _,
          ParameterTarget.Seed _,
          ParameterTarget.RobotModel _ -> {}
    }
  }

  private boolean variable(String what, String variable) {
    if (places.firstValue(variable).isPresent()) {
      return true;
    }
    wrong(what, near(text("noVariable", variable), variable, places::variables));
    return false;
  }

  private void call(String what, int line, String argument) {
    if (line > inputs.program().lineCount()) {
      wrong(what, text("lineBeyondEnd", inputs.program().lineCount(), line));
      return;
    }
    Optional<Expression.Call> call = places.callIn(line);
    if (call.isEmpty()) {
      wrong(what, text("noCall", line));
    } else if (places.parameter(call.get(), argument).isEmpty()) {
      wrong(what, text("noParameter", call.get().function(), line, argument));
    }
  }

  private void base(String what, FrameAxis axis) {
    if (!OF_BASE.contains(axis)) {
      wrong(what, text("baseAxis", axis.word()));
    }
    inputs.equipment().devices().stream()
        .filter(CellShift::standsInCell)
        .map(DeviceSetup::name)
        .forEach(device -> wrong(what, text("baseWithDevice", device)));
  }

  private void feature(String what, String feature) {
    List<String> names =
        inputs.installation().map(Installation::features).orElse(List.of()).stream()
            .map(Feature::name)
            .toList();
    if (!names.contains(feature)) {
      wrong(what, near(text("noFeature", feature), feature, () -> names));
    }
  }
}
