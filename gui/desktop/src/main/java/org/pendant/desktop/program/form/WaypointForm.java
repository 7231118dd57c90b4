package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.kit.form.Measure;
import org.pendant.kit.text.Messages;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.Identifiers;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MotionStep.Waypoint;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.NodeField;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.PlaceNames;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Timing;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/** Waypoint form. */
final class WaypointForm {
  private WaypointForm() {}

  static NodeForm of(FormContext context, Waypoint waypoint) {
    Kept kept = context.kept();
    kept.keep(waypoint.target());
    kept.keep(waypoint.timing());
    FormBuilder form =
        new FormBuilder(context, "waypoint", text("waypoint"), text("aPlaceThatTheMoveGoes"));
    form.part(text("waypoint"))
        .sides(
            "target",
            text("kind"),
            List.of(
                new Option("fixed", text("fixed")),
                new Option("relative", text("relative")),
                new Option("variable", text("variable"))),
            switch (waypoint.target()) {
              case WaypointTarget.Fixed _ -> "fixed";
              case WaypointTarget.Relative _ -> "relative";
              case WaypointTarget.Variable _ -> "variable";
            },
            chosen -> at(waypoint, target(context, chosen)));
    switch (waypoint.target()) {
      case WaypointTarget.Fixed fixed -> fixed(form, waypoint, fixed);
      case WaypointTarget.Relative relative -> relative(form, waypoint, relative);
      case WaypointTarget.Variable(String expression) ->
          form.expression(
                  "target.expression",
                  text("position"),
                  expression,
                  text("suchAsPickPose"),
                  text -> at(waypoint, new WaypointTarget.Variable(text)))
              .quiet(
                  "variable-hint",
                  text("aPoseInOrAList", FormContext.shown(context.moveFeature())));
    }
    timing(form, waypoint);
    MotionForms.blend(
        form,
        waypoint.blendRadiusM(),
        radius -> new Waypoint(waypoint.target(), waypoint.timing(), radius));
    return form.build();
  }

  private static Waypoint at(Waypoint was, WaypointTarget target) {
    return new Waypoint(target, was.timing(), was.blendRadiusM());
  }

  private static WaypointTarget target(FormContext context, String chosen) {
    Kept kept = context.kept();
    ProgramTree tree = context.tree();
    return switch (chosen) {
      case "fixed" ->
          kept.recall(WaypointTarget.Fixed.class)
              .orElseGet(() -> new WaypointTarget.Fixed(WaypointNames.free(tree, "Waypoint_")));
      case "relative" ->
          kept.recall(WaypointTarget.Relative.class)
              .orElseGet(
                  () -> new WaypointTarget.Relative(WaypointNames.free(tree, "Waypoint_"), "", ""));
      default -> kept.recall(WaypointTarget.Variable.class, new WaypointTarget.Variable(""));
    };
  }

  private static void fixed(FormBuilder form, Waypoint waypoint, WaypointTarget.Fixed fixed) {
    FormContext context = form.context();
    ProgramTree tree = context.tree();
    String name = fixed.name();
    form.add(
        new Item.Text(
            "target.name",
            text("name"),
            name,
            text("suchAsWaypoint"),
            List.of(),
            text -> nameRefusal(tree, name, text.strip()),
            text -> renamed(context, waypoint, name, text.strip())));
    Teachable place =
        new Teachable(
            context,
            "position",
            text("positionOf"),
            name,
            "Waypoint_",
            (now, chosen) ->
                now.withStep(context.key(), at(waypoint, new WaypointTarget.Fixed(chosen))));
    form.add(place.choice());
    long uses = WaypointNames.uses(tree, name);
    if (uses > 1) {
      form.quiet("shared", text("nodesShareThisPositionAndIts", uses));
      form.presses(
          "own",
          "",
          form.edit(
              "make-own",
              text("makeAPositionOfItsOwn"),
              text("copyThePositionUnderANew"),
              now -> own(context, waypoint, now, name)));
    }
    form.part(text("position")).add(withoutLabel(place.buttons()));
    WaypointPosition position = tree.waypoints().get(name);
    if (position == null) {
      form.note("untaught", Item.Tone.WARNING, text("notTaughtYetPutTheTool"));
    } else {
      position(form, name, position);
    }
  }

  private static Item withoutLabel(Item.Presses buttons) {
    return new Item.Presses(buttons.name(), "", buttons.buttons());
  }

  /** Why a name cannot be given to a place; empty if it can. */
  static String nameRefusal(ProgramTree tree, String was, String name) {
    if (name.isEmpty()) {
      return text("emptyMustBeAName");
    }
    if (!name.equals(was) && WaypointNames.of(tree).contains(name)) {
      return text("isAnotherWaypointChooseItUnder", name);
    }
    return Identifiers.formRefusal(name).map(Messages::shown).orElse("");
  }

  private static ProgramTree renamed(
      FormContext context, Waypoint waypoint, String from, String to) {
    return from.isEmpty()
        ? context.with(at(waypoint, new WaypointTarget.Fixed(to)))
        : PlaceNames.renamed(context.tree(), from, to);
  }

  private static ProgramTree own(
      FormContext context, Waypoint waypoint, ProgramTree now, String name) {
    String free = WaypointNames.free(now, "Waypoint_");
    ProgramTree next = now.withStep(context.key(), at(waypoint, new WaypointTarget.Fixed(free)));
    WaypointPosition position = now.waypoints().get(name);
    return position == null ? next : next.withWaypoint(free, position);
  }

  /** The numbers of a place that was taught. */
  private static void position(FormBuilder form, String name, WaypointPosition position) {
    FormContext context = form.context();
    Installation installation = context.installation();
    ArmDescription arm = context.host().state().arm().description();
    List<Item.Quantity> joints = new ArrayList<>();
    for (int i = 0; i < Joints.COUNT; i++) {
      int joint = i;
      joints.add(
          number(
              context,
              name,
              NodeFields.placeJoint(i),
              Taught.joint(i),
              position.jointsRad().get(i),
              value ->
                  Taught.withJoints(
                      position, position.jointsRad().with(joint, value), arm, installation)));
    }
    form.add(new Item.Grid("joints", text("joints"), 2, joints));
    form.add(
        pose(
            context,
            name,
            position.tcp(),
            pose -> Taught.withTcp(position, pose, arm, installation)));
    boolean known = Taught.frame(installation, position.feature()).isPresent();
    form.quiet(
        "frame",
        text(
            "inWithTheTcpAtFrom",
            FormContext.shown(position.feature()),
            context.host().poseForm().place(position.toolInFlange())));
    form.note(
        "frame-missing",
        Item.Tone.WARNING,
        known ? "" : text("isMissingInTheInstallationOr", position.feature()));
    form.note(
        "reach",
        Item.Tone.WARNING,
        known
            ? Taught.remark(
                position,
                arm,
                installation,
                ShownMeasure.of(Measure.DEGREE, context.host().poseForm()))
            : "");
  }

  /** A position for a pose. */
  @FunctionalInterface
  interface OfPose {
    WaypointPosition position(Pose pose);
  }

  private static Item.Grid pose(FormContext context, String waypoint, Pose pose, OfPose position) {
    PoseForm form = context.host().poseForm();
    double[] shown = form.numbers(pose);
    List<Item.Quantity> numbers = new ArrayList<>();
    for (int i = 0; i < Pose.SIZE; i++) {
      int changed = i;
      numbers.add(
          number(
              context,
              waypoint,
              NodeFields.placePose(i),
              form.labels().get(i),
              shown[i],
              value -> {
                double[] typed = shown.clone();
                typed[changed] = value;
                return position.position(form.pose(typed));
              }));
    }
    return new Item.Grid("pose", text("pose"), 2, numbers);
  }

  /** A position for a number. */
  @FunctionalInterface
  private interface OfNumber {
    WaypointPosition position(double value);
  }

  private static Item.Quantity number(
      FormContext context,
      String waypoint,
      NodeField field,
      String label,
      double value,
      OfNumber position) {
    return new Item.Quantity(
        field,
        label,
        OptionalDouble.of(value),
        field.range(),
        "",
        ShownMeasure.of(Item.Quantity.measureOf(field), context.host().poseForm()),
        typed -> context.tree().withWaypoint(waypoint, position.position(typed.orElse(value))));
  }

  private static void relative(
      FormBuilder form, Waypoint waypoint, WaypointTarget.Relative relative) {
    FormContext context = form.context();
    form.text(
            "target.name",
            text("name"),
            relative.name(),
            text("forPeople"),
            name -> at(waypoint, new WaypointTarget.Relative(name, relative.from(), relative.to())))
        .quiet("relative-hint", text("goesAsFarFromWhereThe"));
    String prefix = Identifiers.wellFormed(relative.name()) ? relative.name() : "Waypoint";
    form.part(text("places"));
    new Teachable(
            context,
            "target.from",
            text("fromPlace"),
            relative.from(),
            prefix + "_from_",
            (now, chosen) ->
                now.withStep(
                    context.key(),
                    at(
                        waypoint,
                        new WaypointTarget.Relative(relative.name(), chosen, relative.to()))))
        .addTo(form);
    new Teachable(
            context,
            "target.to",
            text("toPlace"),
            relative.to(),
            prefix + "_to_",
            (now, chosen) ->
                now.withStep(
                    context.key(),
                    at(
                        waypoint,
                        new WaypointTarget.Relative(relative.name(), relative.from(), chosen))))
        .addTo(form);
  }

  private static void timing(FormBuilder form, Waypoint waypoint) {
    FormContext context = form.context();
    Kept kept = context.kept();
    MoveKind kind = context.moveKind();

    form.part(text("speed"))
        .sides(
            "timing",
            "",
            List.of(
                new Option("move", text("asTheMoveOption")),
                new Option("own", text("ownSpeed")),
                new Option("time", text("inATime"))),
            switch (waypoint.timing()) {
              case Timing.AsMove _ -> "move";
              case Timing.Own _ -> "own";
              case Timing.Duration _ -> "time";
            },
            chosen ->
                timed(
                    waypoint,
                    switch (chosen) {
                      case "move" -> new Timing.AsMove();
                      case "own" -> kept.recall(Timing.Own.class, ofMove(context, kind));
                      default ->
                          kept.recall(
                              Timing.Duration.class,
                              new Timing.Duration(NodeFields.WAYPOINT_TIME.initialValue()));
                    }));
    switch (waypoint.timing()) {
      case Timing.AsMove _ -> {}
      case Timing.Own(double speed, double acceleration) ->
          form.number(
                  NodeFields.waypointSpeed(kind),
                  kind == MoveKind.JOINT ? text("jointSpeed") : text("toolSpeed"),
                  speed,
                  context.usualSpeed(kind),
                  value -> timed(waypoint, new Timing.Own(value, acceleration)))
              .number(
                  NodeFields.waypointAcceleration(kind),
                  text("acceleration"),
                  acceleration,
                  value -> timed(waypoint, new Timing.Own(speed, value)));
      case Timing.Duration(double timeS) ->
          form.number(
              NodeFields.WAYPOINT_TIME,
              text("time"),
              timeS,
              value -> timed(waypoint, new Timing.Duration(value)));
    }
  }

  private static Waypoint timed(Waypoint was, Timing timing) {
    return new Waypoint(was.target(), timing, was.blendRadiusM());
  }

  private static Timing.Own ofMove(FormContext context, MoveKind kind) {
    return context
        .above(MotionStep.Move.class)
        .map(move -> new Timing.Own(move.speed(), move.acceleration()))
        .orElse(
            new Timing.Own(
                NodeFields.waypointSpeed(kind).initialValue(),
                NodeFields.waypointAcceleration(kind).initialValue()));
  }
}
