package org.pendant.desktop.program.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.pendant.controller.installation.NamedTool;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.kit.form.Measure;
import org.pendant.models.arm.Joints;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.NodeField;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Step;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;

/** Motion forms: those of moves and of what belongs to them, without waypoints. */
final class MotionForms {
  static final String NO_FEATURE = "is no feature of the installation";
  private static final String NAMED = "tcp:";

  private MotionForms() {}

  static NodeForm of(FormContext context, MotionStep step) {
    return switch (step) {
      case MotionStep.Move move -> move(context, move);
      case MotionStep.Waypoint waypoint -> WaypointForm.of(context, waypoint);
      case MotionStep.CircleMove circle -> circle(context, circle);
      case MotionStep.Direction direction -> DirectionForm.of(context, direction);
      case MotionStep.Until until -> until(context, until.rule());
      case MotionStep.Home home -> home(context, home);
    };
  }

  private static NodeForm move(FormContext context, MotionStep.Move move) {
    boolean joint = move.kind() == MoveKind.JOINT;

    context.kept().keep(joint ? "joint" : "tool", move);
    FormBuilder form =
        new FormBuilder(context, "move", words(move.kind()), about(move.kind())).part("Path");
    form.add(
        new Item.Choice(
            "kind",
            "Kind",
            List.of(
                new Option(MoveKind.JOINT.name(), "MoveJ"),
                new Option(MoveKind.LINEAR.name(), "MoveL"),
                new Option(MoveKind.PROCESS.name(), "MoveP")),
            move.kind().name(),
            true,
            "",
            kind -> withKind(context, move, MoveKind.valueOf(kind))));
    form.number(
            NodeFields.speed(move.kind()),
            joint ? "Joint speed" : "Tool speed",
            move.speed(),
            context.usualSpeed(move.kind()),
            value -> motion(move, value, move.acceleration()))
        .number(
            NodeFields.acceleration(move.kind()),
            "Acceleration",
            move.acceleration(),
            value -> motion(move, move.speed(), value));
    if (joint) {
      form.check(
          "byJoints",
          "Go to the taught joint angles",
          move.byJoints(),
          value -> frame(move, move.tool(), move.feature(), value));
    }
    form.part("Frame");
    tool(form, move.tool(), tool -> frame(move, tool, move.feature(), move.byJoints()));
    form.choice(
        "feature",
        "Feature",
        context.features(),
        move.feature(),
        NO_FEATURE,
        feature -> frame(move, move.tool(), feature, move.byJoints()));
    form.quiet(
        "feature-hint",
        "New waypoints are taught in the feature; those that are taught keep theirs.");
    return form.build();
  }

  /** What people call a sort of path. */
  static String words(MoveKind kind) {
    return switch (kind) {
      case JOINT -> "MoveJ";
      case LINEAR -> "MoveL";
      case PROCESS -> "MoveP";
    };
  }

  private static String about(MoveKind kind) {
    return switch (kind) {
      case JOINT -> "Each joint goes its own way to the waypoints below; the quickest move.";
      case LINEAR -> "The tool goes along straight lines to the waypoints below.";
      case PROCESS -> "The tool goes at constant speed, with round corners and circles.";
    };
  }

  private static MotionStep.Move motion(MotionStep.Move move, double speed, double acceleration) {
    return new MotionStep.Move(
        move.kind(), speed, acceleration, move.tool(), move.feature(), move.byJoints());
  }

  private static MotionStep.Move frame(
      MotionStep.Move move, ToolChoice tool, String feature, boolean byJoints) {
    return new MotionStep.Move(
        move.kind(), move.speed(), move.acceleration(), tool, feature, byJoints);
  }

  /** Between joint and tool speeds, what was typed before counts; nothing is converted. */
  private static ProgramTree withKind(FormContext context, MotionStep.Move move, MoveKind kind) {
    boolean joint = kind == MoveKind.JOINT;
    boolean same = joint == (move.kind() == MoveKind.JOINT);
    MotionStep.Move speeds =
        same
            ? move
            : context
                .kept()
                .recall(joint ? "joint" : "tool", MotionStep.Move.class)
                .orElse(
                    motion(
                        move,
                        NodeFields.speed(kind).initialValue(),
                        NodeFields.acceleration(kind).initialValue()));
    ProgramTree tree =
        context.with(
            new MotionStep.Move(
                kind,
                speeds.speed(),
                speeds.acceleration(),
                move.tool(),
                move.feature(),
                joint && speeds.byJoints()));
    return same ? tree : withoutOwnSpeeds(context, tree, context.node());
  }

  /** Numbers in rad/s are no speeds in m/s: the waypoints take those of the move. */
  private static ProgramTree withoutOwnSpeeds(
      FormContext context, ProgramTree tree, ProgramNode node) {
    ProgramTree result = tree;
    for (ProgramNode child : node.children()) {
      if (child.step() instanceof MotionStep.Waypoint waypoint
          && waypoint.timing() instanceof Timing.Own) {
        result =
            result.withStep(
                child.key(),
                new MotionStep.Waypoint(
                    waypoint.target(), new Timing.AsMove(), waypoint.blendRadiusM()));
      } else if (!(child.step() instanceof MotionStep.Move)) {
        result = withoutOwnSpeeds(context, result, child);
      }
    }
    return result;
  }

  /** Which TCP. */
  static void tool(FormBuilder form, ToolChoice tool, Function<ToolChoice, Step> step) {
    List<Option> options = new ArrayList<>();
    options.add(new Option("active", "Active TCP"));
    options.add(new Option("flange", "Flange, no TCP"));
    for (NamedTool each : form.context().installation().tools()) {
      options.add(new Option(NAMED + each.name(), each.name()));
    }
    String value =
        switch (tool) {
          case ToolChoice.Active _ -> "active";
          case ToolChoice.Flange _ -> "flange";
          case ToolChoice.Named(String name) -> NAMED + name;
        };
    form.choice(
        "tool",
        "TCP",
        options,
        value,
        "is no TCP of the installation",
        chosen ->
            step.apply(
                switch (chosen) {
                  case "active" -> new ToolChoice.Active();
                  case "flange" -> new ToolChoice.Flange();
                  default -> new ToolChoice.Named(chosen.substring(NAMED.length()));
                }));
  }

  private static NodeForm circle(FormContext context, MotionStep.CircleMove circle) {
    FormBuilder form =
        new FormBuilder(
                context,
                "circle-move",
                "Circle",
                "An arc through the first waypoint below to the second.")
            .part("Arc")
            .either(
                "fixedOrientation",
                "Tool",
                "Turns with the arc",
                "Turns evenly",
                circle.fixedOrientation(),
                value -> new MotionStep.CircleMove(value, circle.blendRadiusM()))
            .quiet(
                "orientation-hint",
                circle.fixedOrientation()
                    ? "The tool keeps its orientation to the arc; the orientation of the end does"
                        + " not count."
                    : "The tool turns evenly to the orientation of the end.");
    blend(
        form,
        circle.blendRadiusM(),
        radius -> new MotionStep.CircleMove(circle.fixedOrientation(), radius));
    int points = context.node().children().size();
    return form.note(
            "points",
            Item.Tone.WARNING,
            points == 2 ? "" : "It needs two waypoints below it and has " + points + ".")
        .build();
  }

  /** Stop, or a round corner. */
  static void blend(FormBuilder form, OptionalDouble radiusM, Function<OptionalDouble, Step> step) {
    blend(form, NodeFields.BLEND_RADIUS, radiusM, step);
  }

  private static void blend(
      FormBuilder form,
      NodeField field,
      OptionalDouble radiusM,
      Function<OptionalDouble, Step> step) {
    Kept kept = form.context().kept();
    radiusM.ifPresent(radius -> kept.keep("blend", radius));
    form.part("Corner")
        .either(
            "blend",
            "Here",
            "Stop",
            "Blend",
            radiusM.isEmpty(),
            stop ->
                step.apply(
                    stop
                        ? OptionalDouble.empty()
                        : OptionalDouble.of(
                            kept.recall("blend", Double.class).orElse(field.initialValue()))));
    if (radiusM.isPresent()) {
      form.number(
          field, "Radius", radiusM.getAsDouble(), value -> step.apply(OptionalDouble.of(value)));
    }
  }

  private static NodeForm until(FormContext context, UntilRule rule) {
    context.kept().keep(rule);
    FormBuilder form =
        new FormBuilder(
            context, "until", "Until", "Ends the way early. The nodes below it run after that.");
    Kept kept = context.kept();
    form.part("Ends when")
        .sides(
            "rule",
            "",
            List.of(
                new Option("distance", "Distance"),
                new Option("contact", "Contact"),
                new Option("expression", "Expression"),
                new Option("input", "Input")),
            switch (rule) {
              case UntilRule.Distance _ -> "distance";
              case UntilRule.Contact _ -> "contact";
              case UntilRule.Expression _ -> "expression";
              case UntilRule.DigitalInput _ -> "input";
            },
            chosen -> new MotionStep.Until(rule(kept, chosen)));
    switch (rule) {
      case UntilRule.Distance(double distanceM, OptionalDouble blendRadiusM) -> {
        form.number(
            NodeFields.UNTIL_DISTANCE,
            "Distance",
            distanceM,
            value -> new MotionStep.Until(new UntilRule.Distance(value, blendRadiusM)));
        blend(
            form,
            NodeFields.UNTIL_BLEND_RADIUS,
            blendRadiusM,
            radius -> new MotionStep.Until(new UntilRule.Distance(distanceM, radius)));
      }
      case UntilRule.Contact(double retractM, double decelerationMPerS2) ->
          form.number(
                  NodeFields.RETRACTION,
                  "Go back",
                  retractM,
                  value -> new MotionStep.Until(new UntilRule.Contact(value, decelerationMPerS2)))
              .number(
                  NodeFields.CONTACT_DECELERATION,
                  "Deceleration",
                  decelerationMPerS2,
                  value -> new MotionStep.Until(new UntilRule.Contact(retractM, value)))
              .quiet(
                  "contact-hint",
                  "How far the tool goes back from where it touched; 0 stays there, a negative"
                      + " number moves on past it.");
      case UntilRule.Expression(String condition) ->
          form.condition(
              "rule.condition",
              "Condition",
              condition,
              "such as force() > 20",
              value -> new MotionStep.Until(new UntilRule.Expression(value)));
      case UntilRule.DigitalInput(String signal, boolean level) ->
          form.choice(
                  "rule.signal",
                  "Input",
                  context.signals().digitalInputs(),
                  signal,
                  "is no digital input",
                  value -> new MotionStep.Until(new UntilRule.DigitalInput(value, level)))
              .either(
                  "rule.level",
                  "Becomes",
                  "High",
                  "Low",
                  level,
                  value -> new MotionStep.Until(new UntilRule.DigitalInput(signal, value)));
    }
    return form.build();
  }

  private static UntilRule rule(Kept kept, String chosen) {
    return switch (chosen) {
      case "distance" ->
          kept.recall(
              UntilRule.Distance.class,
              new UntilRule.Distance(NodeFields.UNTIL_DISTANCE.initialValue()));
      case "contact" ->
          kept.recall(
              UntilRule.Contact.class,
              new UntilRule.Contact(
                  NodeFields.RETRACTION.initialValue(),
                  NodeFields.CONTACT_DECELERATION.initialValue()));
      case "expression" -> kept.recall(UntilRule.Expression.class, new UntilRule.Expression(""));
      default ->
          kept.recall(
              UntilRule.DigitalInput.class, new UntilRule.DigitalInput("digital_in[0]", true));
    };
  }

  private static NodeForm home(FormContext context, MotionStep.Home home) {
    FormBuilder form =
        new FormBuilder(
                context,
                "home",
                "Home",
                "Moves all joints to the home position of the installation.")
            .part("Motion")
            .number(
                NodeFields.HOME_SPEED,
                "Joint speed",
                home.speedRadPerS(),
                context.usualSpeed(MoveKind.JOINT),
                value -> new MotionStep.Home(value, home.accelerationRadPerS2(), home.timeS()))
            .number(
                NodeFields.HOME_ACCELERATION,
                "Acceleration",
                home.accelerationRadPerS2(),
                value -> new MotionStep.Home(home.speedRadPerS(), value, home.timeS()))
            .optional(
                NodeFields.HOME_TIME,
                "Time",
                home.timeS(),
                "by speed",
                value ->
                    new MotionStep.Home(home.speedRadPerS(), home.accelerationRadPerS2(), value))
            .quiet("time-hint", "With a time, speed and acceleration do not count.");
    Joints at = context.installation().homeRad();
    List<String> places = new ArrayList<>();
    for (int i = 0; i < Joints.COUNT; i++) {
      places.add(Taught.joint(i).toLowerCase(Locale.ROOT) + " " + Measure.DEGREE.text(at.get(i)));
    }
    return form.part("Where it is")
        .quiet("place", "Joints in deg: " + String.join(", ", places) + ".")
        .build();
  }
}
