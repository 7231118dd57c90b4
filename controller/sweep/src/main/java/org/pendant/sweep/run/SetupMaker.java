package org.pendant.sweep.run;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.InputChange;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.SignalText;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.world.Scene;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Expression;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.sweep.plan.FrameAxis;
import org.pendant.sweep.plan.ParameterTarget;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.SweepParameter;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.plan.SweepVariant;

/** Setup maker: what one variant differs by, on the way to its setup. Mutable, for one variant. */
final class SetupMaker {
  private final JobInputs inputs;
  private final ScriptPlaces places;
  private final TextChanges text = new TextChanges();
  private final List<SignalWrite> signals = new ArrayList<>();
  private final List<InputChange> timed = new ArrayList<>();
  private final Map<FrameAxis, Double> base = new EnumMap<>(FrameAxis.class);
  private final double[] load = new double[4];
  private boolean loaded;
  private OptionalDouble slider = OptionalDouble.empty();
  private String robot;
  private long seed;
  private Scene scene;
  private List<Feature> features;

  private SetupMaker(JobInputs inputs, ScriptPlaces places) {
    this.inputs = inputs;
    this.places = places;
    robot = inputs.robot();
    seed = inputs.plan().settings().seed();
    scene = inputs.scene();
    features = inputs.installation().map(Installation::features).orElse(List.of());
  }

  /**
   * The setup of a variant.
   *
   * @throws IllegalArgumentException if its values cannot be: a slider beyond 1, an object outside
   *     of its range
   */
  static VariantSetup of(JobInputs inputs, ScriptPlaces places, SweepVariant variant) {
    SetupMaker maker = new SetupMaker(inputs, places);
    SweepPlan plan = inputs.plan();
    for (int i = 0; i < plan.parameters().size(); i++) {
      SweepParameter parameter = plan.parameters().get(i);
      maker.set(parameter.target(), variant.values().get(i));
    }
    return maker.setup();
  }

  private void set(ParameterTarget target, ParameterValue value) {
    switch (target) {
      case ParameterTarget.Variable variable -> {
        Optional<Expression> at =
            variable.element().isPresent()
                ? places.firstElement(variable.name(), variable.element().getAsInt())
                : places.firstValue(variable.name());
        text.replace(at.orElseThrow().range(), value.text());
      }
      case ParameterTarget.CallArgument(var line, var argument) -> {
        Expression.Call call = places.callIn(line).orElseThrow();
        places.give(text, call, places.parameter(call, argument).orElseThrow(), value.text());
      }
      case ParameterTarget.MoveFactor(var argument) ->
          places.scaleMoves(text, argument, value.text());
      case ParameterTarget.Slider _ -> {
        if (!(value.number() >= 0 && value.number() <= 1)) {
          throw new IllegalArgumentException("slider is " + value.text() + ", must be 0 to 1");
        }
        slider = OptionalDouble.of(value.number());
      }
      case ParameterTarget.Load(var component) -> {
        load[component] = value.number();
        loaded = true;
      }
      case ParameterTarget.BasePlace(var axis) -> base.put(axis, value.number());
      case ParameterTarget.FeaturePlace(var name, var axis) ->
          features = CellShift.withFeature(features, name, axis, value.number());
      case ParameterTarget.ObjectPlace(var name, var axis) ->
          scene = CellShift.withObject(scene, name, axis, value.number());
      case ParameterTarget.InputLevel(var signal) ->
          signals.addAll(SignalText.input(signal, value.text().toLowerCase(Locale.ROOT)));
      case ParameterTarget.InputTime(var signal) ->
          timed.add(new InputChange(value.number(), signal, "true"));
      case ParameterTarget.Seed _ -> seed = (long) value.number();
      case ParameterTarget.RobotModel _ -> robot = value.text();
    }
  }

  private VariantSetup setup() {
    Optional<Installation> installed = inputs.installation();
    ControllerOptions options = inputs.options(robot, installed).withSeed(seed);
    if (!base.isEmpty()) {
      Pose by = Poses.inverse(basePlace());
      scene = CellShift.seenFrom(scene, by);
      features = features.stream().map(each -> CellShift.moved(each, by)).toList();
      options = options.withSafety(CellShift.seenFrom(options.safety(), by));
      for (String each : inputs.plan().settings().fixed()) {
        Expression value = places.firstValue(each).orElseThrow();
        text.wrap(value.range(), "pose_trans(" + text(by) + ", ", ")");
      }
    }
    if (installed.isPresent()) {
      options = options.withInstallation(installed.get().withFeatures(features));
    }
    List<SignalWrite> writes = new ArrayList<>(inputs.signals());
    writes.addAll(signals);
    return new VariantSetup(
        options.withScene(scene).withSignals(writes),
        program(),
        timed.isEmpty() ? InputWaveforms.NONE : new InputWaveforms(timed, OptionalDouble.empty()),
        slider,
        loaded ? Optional.of(Payload.of(load[0], load[1], load[2], load[3])) : Optional.empty());
  }

  private Source program() {
    return text.in(inputs.program());
  }

  private Pose basePlace() {
    Pose place = Pose.ZERO;
    for (Map.Entry<FrameAxis, Double> each : base.entrySet()) {
      place = place.with(each.getKey().ordinal(), each.getValue());
    }
    return place;
  }

  /** With all digits. */
  private static String text(Pose pose) {
    return Arrays.stream(pose.toArray())
        .mapToObj(each -> ParameterValue.of(each).text())
        .collect(Collectors.joining(", ", "p[", "]"));
  }
}
