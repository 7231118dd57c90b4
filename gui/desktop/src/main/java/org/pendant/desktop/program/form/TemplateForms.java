package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

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
          case APPROACH -> text("approach");
          case POINT -> text("patternPoint");
          case EXIT -> text("exit");
        };
    String about =
        switch (point.role()) {
          case APPROACH -> text("whereTheToolComesFromSeen");
          case POINT -> text("thePlaceOfThePatternItself");
          case EXIT -> text("whereTheToolGoesAfterwardsSeen");
        };
    FormBuilder form = new FormBuilder(context, "pattern-point", title, about);
    form.part(text("placePart"));
    new Teachable(
            context,
            "waypoint",
            text("waypoint"),
            point.waypoint(),
            prefix(point.role()),
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
            ? text("teachItWithTheToolAt")
            : text("teachItForTheSameItem"));
    boolean joint = point.kind() == MoveKind.JOINT;
    context.kept().keep(joint ? "joint" : "tool", point);
    form.part(text("motion"))
        .oneOf(
            "kind",
            text("kind"),
            point.kind(),
            MotionForms::words,
            kind -> withKind(context, point, kind))
        .number(
            NodeFields.speed(point.kind()),
            joint ? text("jointSpeed") : text("toolSpeed"),
            point.speed(),
            context.usualSpeed(point.kind()),
            value -> motion(point, point.kind(), value, point.acceleration(), point.blendRadiusM()))
        .number(
            NodeFields.acceleration(point.kind()),
            text("acceleration"),
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
    return new FormBuilder(context, "part", text("partOfATemplate"), text("whenTheNodesBelowItRun"))
        .add(
            new Item.Choice(
                "kind",
                text("runs"),
                List.of(
                    new Option(
                        TemplateStep.PartKind.BEFORE_START.name(), text("beforeTheFirstItem")),
                    new Option(TemplateStep.PartKind.AFTER_END.name(), text("afterTheLastItem")),
                    new Option(TemplateStep.PartKind.SEQUENCE.name(), text("atEachItem"))),
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
        new FormBuilder(context, "seek", text("seek"), text("searchesForTheNextItemOf"));
    form.part(text("stack"))
        .either(
            "destack",
            text("task"),
            text("takeFromIt"),
            text("putOnIt"),
            seek.destack(),
            change::destack)
        .variable("name", text("name"), seek.name(), List.of(), change::name)
        .quiet("count-hint", countHint(seek.name()))
        .number(
            NodeFields.ITEM_HEIGHT,
            text("itemHeight"),
            seek.itemHeightM(),
            value -> change.lengths(seek.limitM(), value))
        .condition(
            "found", text("foundWhen"), seek.found(), text("suchAsForceAbove"), change::found)
        .part(text("seekStart"));
    new Teachable(
            context,
            "start",
            text("seekStart"),
            seek.start(),
            "Seek_start_",
            (now, chosen) -> now.withStep(context.key(), change.start(chosen)))
        .addTo(form);
    form.part(text("search"))
        .choice(
            "feature",
            text("feature"),
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
        text("theStackAndTheDirectionOf"));
    form.number(
            NodeFields.SEEK_LIMIT,
            text("atMost"),
            seek.limitM(),
            value -> change.lengths(value, seek.itemHeightM()))
        .number(
            NodeFields.SEEK_SPEED,
            text("toolSpeed"),
            seek.speedMPerS(),
            value -> change.motion(value, seek.accelerationMPerS2()))
        .number(
            NodeFields.SEEK_ACCELERATION,
            text("acceleration"),
            seek.accelerationMPerS2(),
            value -> change.motion(seek.speedMPerS(), value));
    return form.build();
  }

  /** How names of waypoints begin that are made for a point, in any language of the window. */
  private static String prefix(TemplateStep.PatternRole role) {
    return switch (role) {
      case APPROACH -> "Approach_";
      case POINT -> "Pattern_point_";
      case EXIT -> "Exit_";
    };
  }

  static String countHint(String name) {
    return name.isEmpty()
        ? text("theVariableThatCountsIsCalled")
        : text("theVariableCountCounts", name);
  }

  private static NodeForm screwdriving(FormContext context, Screwdriving was) {
    context.kept().keep(was.byForce() ? "force" : "speed", was.value());
    FormBuilder form =
        new FormBuilder(
            context, "screwdriving", text("screwdriving"), text("followsAScrewAlongTheTools"));
    form.part(text("screw"))
        .either(
            "loosen",
            text("task"),
            text("loosen"),
            text("tighten"),
            was.loosen(),
            value -> task(was, value));
    MotionForms.tool(form, was.tool(), tool -> screw(was, tool, was.byForce(), was.value()));
    form.part(text("follow"))
        .either(
            "byForce",
            text("by"),
            text("force"),
            text("speed"),
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
            was.byForce() ? text("force") : text("speed"),
            was.value(),
            value -> screw(was, was.tool(), was.byForce(), value));
    List<Option> outputs =
        FormContext.options(
            List.of(new Option("", text("none"))),
            context.signals().digitalOutputs(),
            each -> each.value());
    form.part(text("driver"))
        .choice(
            "start",
            text("switchedBy"),
            outputs,
            was.start(),
            text("isNoDigitalOutput"),
            start -> control(was, start, was.until(), was.timeoutS()))
        .condition(
            "until",
            text("doneWhen"),
            was.until(),
            text("suchAsGetStandardDigitalIn"),
            until -> control(was, was.start(), until, was.timeoutS()))
        .number(
            NodeFields.SCREW_TIMEOUT,
            text("errorAfter"),
            was.timeoutS(),
            value -> control(was, was.start(), was.until(), value))
        .quiet("timeout-hint", text("zeroWaitsForEver"));
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
                text("conveyorTracking"),
                text("theArmGoesAlongWithA"))
            .sides(
                "conveyor",
                text("conveyor"),
                List.of(new Option("1", text("conveyor1")), new Option("2", text("conveyor2"))),
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
            found.isEmpty() ? text("conveyorIsNotSetUpIn", conveyor) : "")
        .build();
  }

  private static String words(ConveyorSetup setup) {
    return setup.circular()
        ? text("turnsAboutTheZAxisOf", FormContext.shown(setup.feature()), setup.encoder())
        : text("goesAlongTheYAxisOf", FormContext.shown(setup.feature()), setup.encoder());
  }
}
