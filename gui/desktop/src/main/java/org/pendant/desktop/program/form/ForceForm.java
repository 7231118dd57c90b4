package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.TemplateStep.Force;
import org.pendant.project.program.TemplateStep.ForceKind;

/** Force form: that of a node that keeps forces. */
final class ForceForm {
  private static final List<String> AXES = List.of("X", "Y", "Z", "RX", "RY", "RZ");
  private static final int Z = 2;
  private static final int SIZE = 6;

  private ForceForm() {}

  static NodeForm of(FormContext context, Force step) {
    Force force = whole(step);
    boolean simple = force.kind() == ForceKind.SIMPLE;
    FormBuilder form =
        new FormBuilder(context, "force", text("force"), text("givesWayAlongSomeAxesAnd"));
    form.part(text("frame"))
        .add(
            new Item.Choice(
                "kind",
                text("kind"),
                List.of(
                    new Option(ForceKind.SIMPLE.name(), text("simple")),
                    new Option(ForceKind.FRAME.name(), text("frame")),
                    new Option(ForceKind.POINT.name(), text("point")),
                    new Option(ForceKind.MOTION.name(), text("motion"))),
                force.kind().name(),
                true,
                "",
                kind ->
                    context.with(
                        new Force(
                            ForceKind.valueOf(kind),
                            force.feature(),
                            force.compliant(),
                            force.wrench(),
                            force.limits()))))
        .quiet("kind-hint", about(force.kind()))
        .choice(
            "feature",
            text("feature"),
            context.features(),
            force.feature(),
            MotionForms.NO_FEATURE,
            feature ->
                new Force(force.kind(), feature, force.compliant(), force.wrench(), force.limits()))
        .drawing(
            "axes-drawing",
            new Sketch.Axes(
                simple ? List.of(false, false, true, false, false, false) : force.compliant(),
                force.wrench()),
            text("theAxesThatGiveWayWith"));
    form.part(text("axes"));
    for (int axis = 0; axis < SIZE; axis++) {
      if (!simple || axis == Z) {
        axis(form, force, axis, simple);
      }
    }
    form.quiet(
            "axes-hint", simple ? text("theZAxisOfTheFeature") : text("aCheckedAxisGivesWayForce"))
        .quiet("test-hint", text("toTryItRunTheProgram"));
    return form.build();
  }

  private static String about(ForceKind kind) {
    return switch (kind) {
      case SIMPLE -> text("onlyTheZAxisOfThe");
      case FRAME -> text("theAxesOfTheFeatureAs");
      case POINT -> text("theYAxisPointsFromThe");
      case MOTION -> text("theXAxisPointsAlongThe");
    };
  }

  /** With all six numbers of each list. */
  private static Force whole(Force step) {
    List<Boolean> compliant = filled(step.compliant(), _ -> false);
    return new Force(
        step.kind(),
        step.feature(),
        compliant,
        filled(step.wrench(), axis -> NodeFields.wrench(axis).initialValue()),
        filled(
            step.limits(),
            axis -> NodeFields.forceLimit(axis, compliant.get(axis)).initialValue()));
  }

  private static <T> List<T> filled(List<T> values, IntFunction<T> missing) {
    List<T> all = new ArrayList<>(values);
    while (all.size() < SIZE) {
      all.add(missing.apply(all.size()));
    }
    return all;
  }

  private static void axis(FormBuilder form, Force force, int axis, boolean simple) {
    String name = AXES.get(axis);
    boolean line = axis < 3;
    boolean free = simple || force.compliant().get(axis);
    List<Item> items = new ArrayList<>();
    if (!simple) {
      items.add(
          new Item.Check(
              "compliant." + axis,
              name,
              force.compliant().get(axis),
              value ->
                  form.context()
                      .with(
                          lists(
                              force,
                              with(force.compliant(), axis, value),
                              force.wrench(),
                              force.limits()))));
    }
    if (free) {
      items.add(
          form.numberOf(
              NodeFields.wrench(axis),
              line ? text("force") : text("torque"),
              force.wrench().get(axis),
              value ->
                  lists(
                      force,
                      force.compliant(),
                      with(force.wrench(), axis, value),
                      force.limits())));
    }
    items.add(
        form.numberOf(
            NodeFields.forceLimit(axis, free),
            free ? text("speed") : text("deviation"),
            force.limits().get(axis),
            value ->
                lists(
                    force, force.compliant(), force.wrench(), with(force.limits(), axis, value))));
    form.add(new Item.Line("axis-" + axis, simple ? name : "", items));
  }

  private static Force lists(
      Force was, List<Boolean> compliant, List<Double> wrench, List<Double> limits) {
    return new Force(was.kind(), was.feature(), compliant, wrench, limits);
  }

  private static <T> List<T> with(List<T> values, int index, T value) {
    List<T> all = new ArrayList<>(values);
    all.set(index, value);
    return all;
  }
}
