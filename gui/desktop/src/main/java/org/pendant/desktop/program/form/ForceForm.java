package org.pendant.desktop.program.form;

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
        new FormBuilder(
            context,
            "force",
            "Force",
            "Gives way along some axes and presses there while its nodes run.");
    form.part("Frame")
        .add(
            new Item.Choice(
                "kind",
                "Kind",
                List.of(
                    new Option(ForceKind.SIMPLE.name(), "Simple"),
                    new Option(ForceKind.FRAME.name(), "Frame"),
                    new Option(ForceKind.POINT.name(), "Point"),
                    new Option(ForceKind.MOTION.name(), "Motion")),
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
            "Feature",
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
            "The axes that give way, with the direction of the force");
    form.part("Axes");
    for (int axis = 0; axis < SIZE; axis++) {
      if (!simple || axis == Z) {
        axis(form, force, axis, simple);
      }
    }
    form.quiet(
            "axes-hint",
            simple
                ? "The z axis of the feature gives way: the tool presses along it, at most this"
                    + " fast."
                : "A checked axis gives way: force or torque, and the largest speed. The others"
                    + " stay on the path, with the largest deviation.")
        .quiet(
            "test-hint",
            "To try it: run the program slowly with the tool just above the surface, and watch the"
                + " force on the Plots screen.");
    return form.build();
  }

  private static String about(ForceKind kind) {
    return switch (kind) {
      case SIMPLE -> "Only the z axis of the feature gives way.";
      case FRAME -> "The axes of the feature, as it is.";
      case POINT -> "The y axis points from the TCP to the origin of the feature.";
      case MOTION -> "The x axis points along the motion of the TCP.";
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
              line ? "Force" : "Torque",
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
            free ? "Speed" : "Deviation",
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
