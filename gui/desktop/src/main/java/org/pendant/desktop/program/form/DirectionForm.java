package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.NodeField;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.Step;

/** Direction form: a straight move in a direction. */
final class DirectionForm {
  private static final List<String> AXES = List.of("X", "Y", "Z");

  private DirectionForm() {}

  static NodeForm of(FormContext context, MotionStep.Direction step) {
    FormBuilder form =
        new FormBuilder(
            context, "direction", text("direction"), text("movesTheToolStraightOnUntil"));
    form.part(text("direction"))
        .choice(
            "feature",
            text("feature"),
            context.features(),
            step.feature(),
            MotionForms.NO_FEATURE,
            feature -> in(step, feature));
    vector(
        form,
        List.of(step.x(), step.y(), step.z()),
        List.of(NodeFields.DIRECTION_X, NodeFields.DIRECTION_Y, NodeFields.DIRECTION_Z),
        v -> along(step, v));
    form.expression(
        "expression",
        text("orComputed"),
        step.expression(),
        text("suchAsVector"),
        text -> computed(step, text));
    if (step.expression().isBlank()) {
      form.drawing(
          "direction-drawing",
          new Sketch.Arrow(step.x(), step.y(), step.z()),
          text("theDirectionIn", FormContext.shown(step.feature())));
    }
    form.part(text("motion"))
        .optional(
            NodeFields.DIRECTION_SPEED,
            text("toolSpeed"),
            step.speedMPerS(),
            text("asTheMove"),
            value -> motion(step, value, step.accelerationMPerS2()))
        .optional(
            NodeFields.DIRECTION_ACCELERATION,
            text("acceleration"),
            step.accelerationMPerS2(),
            text("asTheMove"),
            value -> motion(step, step.speedMPerS(), value));
    boolean ends =
        context.node().children().stream()
            .anyMatch(each -> each.step() instanceof MotionStep.Until && !each.suppressed());
    return form.note("until", Item.Tone.WARNING, ends ? "" : text("nothingEndsItAddAnUntil"))
        .build();
  }

  private static MotionStep.Direction in(MotionStep.Direction was, String feature) {
    return new MotionStep.Direction(
        feature,
        was.x(),
        was.y(),
        was.z(),
        was.expression(),
        was.speedMPerS(),
        was.accelerationMPerS2());
  }

  /** The numbers take the place of an expression. */
  private static MotionStep.Direction along(MotionStep.Direction was, List<Double> vector) {
    return new MotionStep.Direction(
        was.feature(),
        vector.get(0),
        vector.get(1),
        vector.get(2),
        was.speedMPerS(),
        was.accelerationMPerS2());
  }

  private static MotionStep.Direction computed(MotionStep.Direction was, String expression) {
    return new MotionStep.Direction(
        was.feature(),
        was.x(),
        was.y(),
        was.z(),
        expression,
        was.speedMPerS(),
        was.accelerationMPerS2());
  }

  private static MotionStep.Direction motion(
      MotionStep.Direction was, OptionalDouble speed, OptionalDouble acceleration) {
    return new MotionStep.Direction(
        was.feature(), was.x(), was.y(), was.z(), was.expression(), speed, acceleration);
  }

  /** A step for a vector. */
  @FunctionalInterface
  interface OfVector {
    Step step(List<Double> vector);
  }

  /** Buttons for the axes both ways, and three numbers. */
  static void vector(FormBuilder form, List<Double> now, List<NodeField> fields, OfVector step) {
    FormContext context = form.context();
    List<Item.Press> buttons = new ArrayList<>();
    for (int axis = 0; axis < 3; axis++) {
      for (int sign : new int[] {1, -1}) {
        List<Double> unit = new ArrayList<>(List.of(0.0, 0.0, 0.0));
        unit.set(axis, (double) sign);
        String text = (sign > 0 ? "+" : "\u2212") + AXES.get(axis);
        buttons.add(
            FormBuilder.press(
                "along-"
                    + (sign > 0 ? "plus-" : "minus-")
                    + AXES.get(axis).toLowerCase(Locale.ROOT),
                text,
                text(sign > 0 ? "alongAxis" : "alongNegativeAxis", AXES.get(axis)),
                true,
                () -> context.change(text("changeDirection"), context.with(step.step(unit)))));
      }
    }
    form.add(new Item.Presses("axes", text("along"), buttons));
    List<Item.Quantity> numbers = new ArrayList<>();
    for (int axis = 0; axis < 3; axis++) {
      int changed = axis;
      numbers.add(
          form.numberOf(
              fields.get(axis),
              AXES.get(axis),
              now.get(axis),
              value -> {
                List<Double> vector = new ArrayList<>(now);
                vector.set(changed, value);
                return step.step(vector);
              }));
    }
    form.add(new Item.Grid("vector", text("vector"), 3, numbers));
    boolean none = now.stream().allMatch(each -> Math.abs(each) < 1e-9);
    form.note("vector-zero", Item.Tone.WARNING, none ? text("theDirectionHasNoLengthAt") : "");
  }
}
