package org.pendant.desktop.program.form;

import java.util.List;
import java.util.OptionalDouble;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.SeekChange;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TemplateStep.PatternPoint;
import org.pendant.project.program.TemplateStep.Screwdriving;
import org.pendant.project.program.TemplateStep.Seek;
import org.pendant.project.program.ToolChoice;

/** Template forms; force and palletizing have classes of their own. */
final class TemplateForms {
  private TemplateForms() {}

  static NodeForm of(FormContext context, TemplateStep step) {
    return switch (step) {
      case TemplateStep.Palletizing palletizing -> PalletizingForm.of(context, palletizing);
      case PatternPoint point -> point(context, point);
      case TemplateStep.Part part -> part(context, part);
      case Seek seek -> seek(context, seek);
      case TemplateStep.Force force -> ForceForm.of(context, force);
      case Screwdriving screw -> screwdriving(context, screw);
      case TemplateStep.ConveyorTracking(int conveyor) -> conveyor(context, conveyor);
    };
  }

  private static NodeForm point(FormContext context, PatternPoint point) {
    String title =
        switch (point.role()) {
          case APPROACH -> "Approach";
          case POINT -> "Pattern point";
          case EXIT -> "Exit";
        };
    String about =
        switch (point.role()) {
          case APPROACH -> "Where the tool comes from, seen from the place of the pattern.";
          case POINT -> "The place of the pattern itself; taught at one of them.";
          case EXIT -> "Where the tool goes afterwards, seen from the place of the pattern.";
        };
    FormBuilder form = new FormBuilder(context, "pattern-point", title, about);
    form.part("Place");
    new Teachable(
            context,
            "waypoint",
            "Waypoint",
            point.waypoint(),
            title.replace(' ', '_') + "_",
            (now, chosen) ->
                now.withStep(
                    context.key(),
                    new PatternPoint(
                        point.role(),
                        chosen,
                        point.kind(),
                        point.speed(),
                        point.acceleration(),
                        point.blendRadiusM())))
        .addTo(form);
    form.quiet(
        "teach-hint",
        point.role() == TemplateStep.PatternRole.POINT
            ? "Teach it with the tool at an item."
            : "Teach it for the same item at which the pattern point is taught.");
    boolean joint = point.kind() == MoveKind.JOINT;
    context.kept().keep(joint ? "joint" : "tool", point);
    form.part("Motion")
        .oneOf(
            "kind",
            "Kind",
            point.kind(),
            MotionForms::words,
            kind -> withKind(context, point, kind))
        .number(
            NodeFields.speed(point.kind()),
            joint ? "Joint speed" : "Tool speed",
            point.speed(),
            context.usualSpeed(point.kind()),
            value -> motion(point, point.kind(), value, point.acceleration(), point.blendRadiusM()))
        .number(
            NodeFields.acceleration(point.kind()),
            "Acceleration",
            point.acceleration(),
            value -> motion(point, point.kind(), point.speed(), value, point.blendRadiusM()));
    MotionForms.blend(
        form,
        point.blendRadiusM(),
        radius -> motion(point, point.kind(), point.speed(), point.acceleration(), radius));
    return form.build();
  }

  private static PatternPoint motion(
      PatternPoint was, MoveKind kind, double speed, double acceleration, OptionalDouble blend) {
    return new PatternPoint(was.role(), was.waypoint(), kind, speed, acceleration, blend);
  }

  private static PatternPoint withKind(FormContext context, PatternPoint was, MoveKind kind) {
    boolean joint = kind == MoveKind.JOINT;
    if (joint == (was.kind() == MoveKind.JOINT)) {
      return motion(was, kind, was.speed(), was.acceleration(), was.blendRadiusM());
    }
    return context
        .kept()
        .recall(joint ? "joint" : "tool", PatternPoint.class)
        .map(before -> motion(was, kind, before.speed(), before.acceleration(), was.blendRadiusM()))
        .orElseGet(
            () ->
                motion(
                    was,
                    kind,
                    NodeFields.speed(kind).initialValue(),
                    NodeFields.acceleration(kind).initialValue(),
                    was.blendRadiusM()));
  }

  private static NodeForm part(FormContext context, TemplateStep.Part part) {
    return new FormBuilder(context, "part", "Part of a template", "When the nodes below it run.")
        .add(
            new Item.Choice(
                "kind",
                "Runs",
                List.of(
                    new Option(TemplateStep.PartKind.BEFORE_START.name(), "Before the first item"),
                    new Option(TemplateStep.PartKind.AFTER_END.name(), "After the last item"),
                    new Option(TemplateStep.PartKind.SEQUENCE.name(), "At each item")),
                part.kind().name(),
                false,
                "",
                chosen ->
                    context.with(new TemplateStep.Part(TemplateStep.PartKind.valueOf(chosen)))))
        .build();
  }

  private static NodeForm seek(FormContext context, Seek seek) {
    SeekChange change = new SeekChange(seek);
    FormBuilder form =
        new FormBuilder(
            context,
            "seek",
            "Seek",
            "Searches for the next item of a stack and runs its sequence there.");
    form.part("Stack")
        .either("destack", "Task", "Take from it", "Put on it", seek.destack(), change::destack)
        .variable("name", "Name", seek.name(), List.of(), change::name)
        .quiet("count-hint", countHint(seek.name()))
        .number(
            NodeFields.ITEM_HEIGHT,
            "Item height",
            seek.itemHeightM(),
            value -> change.lengths(seek.limitM(), value))
        .condition("found", "Found when", seek.found(), "such as force() > 20", change::found)
        .part("Start");
    new Teachable(
            context,
            "start",
            "Start",
            seek.start(),
            "Seek_start_",
            (now, chosen) -> now.withStep(context.key(), change.start(chosen)))
        .addTo(form);
    form.part("Search")
        .choice(
            "feature",
            "Feature",
            context.features(),
            seek.feature(),
            MotionForms.NO_FEATURE,
            change::feature);
    List<Double> way =
        seek.direction().size() == 3
            ? seek.direction()
            : List.of(
                NodeFields.SEEK_X.initialValue(),
                NodeFields.SEEK_Y.initialValue(),
                NodeFields.SEEK_Z.initialValue());
    DirectionForm.vector(
        form,
        way,
        List.of(NodeFields.SEEK_X, NodeFields.SEEK_Y, NodeFields.SEEK_Z),
        change::direction);
    form.drawing(
        "stack",
        new Sketch.Stack(seek.destack(), way.get(0), way.get(1), way.get(2)),
        "The stack and the direction of the search");
    form.number(
            NodeFields.SEEK_LIMIT,
            "At most",
            seek.limitM(),
            value -> change.lengths(value, seek.itemHeightM()))
        .number(
            NodeFields.SEEK_SPEED,
            "Tool speed",
            seek.speedMPerS(),
            value -> change.motion(value, seek.accelerationMPerS2()))
        .number(
            NodeFields.SEEK_ACCELERATION,
            "Acceleration",
            seek.accelerationMPerS2(),
            value -> change.motion(seek.speedMPerS(), value));
    return form.build();
  }

  static String countHint(String name) {
    return name.isEmpty()
        ? "The variable that counts is called by the name."
        : "The variable " + name + "_count counts.";
  }

  private static NodeForm screwdriving(FormContext context, Screwdriving was) {
    context.kept().keep(was.byForce() ? "force" : "speed", was.value());
    FormBuilder form =
        new FormBuilder(
            context,
            "screwdriving",
            "Screwdriving",
            "Follows a screw along the tool's z axis while the nodes below run.");
    form.part("Screw")
        .either("loosen", "Task", "Loosen", "Tighten", was.loosen(), value -> task(was, value));
    MotionForms.tool(form, was.tool(), tool -> screw(was, tool, was.byForce(), was.value()));
    form.part("Follow")
        .either(
            "byForce",
            "By",
            "Force",
            "Speed",
            was.byForce(),
            byForce ->
                screw(
                    was,
                    was.tool(),
                    byForce,
                    context
                        .kept()
                        .recall(byForce ? "force" : "speed", Double.class)
                        .orElse(NodeFields.screwValue(byForce).initialValue())))
        .number(
            NodeFields.screwValue(was.byForce()),
            was.byForce() ? "Force" : "Speed",
            was.value(),
            value -> screw(was, was.tool(), was.byForce(), value));
    List<Option> outputs =
        FormContext.options(
            List.of(new Option("", "None")),
            context.signals().digitalOutputs(),
            each -> each.value());
    form.part("Driver")
        .choice(
            "start",
            "Switched by",
            outputs,
            was.start(),
            "is no digital output",
            start -> control(was, start, was.until(), was.timeoutS()))
        .condition(
            "until",
            "Done when",
            was.until(),
            "such as get_standard_digital_in(0)",
            until -> control(was, was.start(), until, was.timeoutS()))
        .number(
            NodeFields.SCREW_TIMEOUT,
            "Error after",
            was.timeoutS(),
            value -> control(was, was.start(), was.until(), value))
        .quiet("timeout-hint", "0 waits for ever.");
    return form.build();
  }

  private static Screwdriving task(Screwdriving was, boolean loosen) {
    return new Screwdriving(
        was.tool(), was.byForce(), was.value(), loosen, was.start(), was.until(), was.timeoutS());
  }

  private static Screwdriving screw(
      Screwdriving was, ToolChoice tool, boolean byForce, double value) {
    return new Screwdriving(
        tool, byForce, value, was.loosen(), was.start(), was.until(), was.timeoutS());
  }

  private static Screwdriving control(
      Screwdriving was, String start, String until, double timeoutS) {
    return new Screwdriving(
        was.tool(), was.byForce(), was.value(), was.loosen(), start, until, timeoutS);
  }

  private static NodeForm conveyor(FormContext context, int conveyor) {
    List<ConveyorSetup> known = context.installation().conveyors();
    FormBuilder form =
        new FormBuilder(
                context,
                "conveyor-tracking",
                "Conveyor tracking",
                "The arm goes along with a conveyor while the nodes below run.")
            .sides(
                "conveyor",
                "Conveyor",
                List.of(new Option("1", "Conveyor 1"), new Option("2", "Conveyor 2")),
                Integer.toString(conveyor),
                chosen -> new TemplateStep.ConveyorTracking(Integer.parseInt(chosen)));
    String found =
        known.stream()
            .filter(each -> each.number() == conveyor)
            .map(TemplateForms::words)
            .findFirst()
            .orElse("");
    return form.quiet("setup", found)
        .note(
            "missing",
            Item.Tone.WARNING,
            found.isEmpty() ? "Conveyor " + conveyor + " is not set up in the installation." : "")
        .build();
  }

  private static String words(ConveyorSetup setup) {
    return setup.circular()
        ? "Turns about the z axis of " + setup.feature() + ", encoder " + setup.encoder() + "."
        : "Goes along the y axis of " + setup.feature() + ", encoder " + setup.encoder() + ".";
  }
}
