package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.pendant.controller.installation.NamedTool;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.kit.form.Measure;
import org.pendant.kit.text.Messages;
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
  static final String NO_FEATURE = text("isNoFeatureOfTheInstallation");
  private static final String NAMED = "tcp:";
  private static final List<String> JOINTS =
      List.of("baseAt", "shoulderAt", "elbowAt", "wrist1At", "wrist2At", "wrist3At");

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
        new FormBuilder(context, "move", words(move.kind()), about(move.kind())).part(text("path"));
    form.add(
        new Item.Choice(
            "kind",
            text("kind"),
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
            joint ? text("jointSpeed") : text("toolSpeed"),
            move.speed(),
            context.usualSpeed(move.kind()),
            value -> motion(move, value, move.acceleration()))
        .number(
            NodeFields.acceleration(move.kind()),
            text("acceleration"),
            move.acceleration(),
            value -> motion(move, move.speed(), value));
    if (joint) {
      form.check(
          "byJoints",
          text("goToTheTaughtJointAngles"),
          move.byJoints(),
          value -> frame(move, move.tool(), move.feature(), value));
    }
    form.part(text("frame"));
    tool(form, move.tool(), tool -> frame(move, tool, move.feature(), move.byJoints()));
    form.choice(
        "feature",
        text("feature"),
        context.features(),
        move.feature(),
        NO_FEATURE,
        feature -> frame(move, move.tool(), feature, move.byJoints()));
    form.quiet("feature-hint", text("newWaypointsAreTaughtInThe"));
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
      case JOINT -> text("eachJointGoesItsOwnWay");
      case LINEAR -> text("theToolGoesAlongStraightLines");
      case PROCESS -> text("theToolGoesAtConstantSpeed");
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
    options.add(new Option("active", text("activeTcp")));
    options.add(new Option("flange", text("flangeNoTcp")));
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
        text("isNoTcpOfTheInstallation"),
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
                context, "circle-move", text("circle"), text("anArcThroughTheFirstWaypoint"))
            .part(text("arc"))
            .either(
                "fixedOrientation",
                text("tool"),
                text("turnsWithTheArc"),
                text("turnsEvenly"),
                circle.fixedOrientation(),
                value -> new MotionStep.CircleMove(value, circle.blendRadiusM()))
            .quiet(
                "orientation-hint",
                circle.fixedOrientation()
                    ? text("theToolKeepsItsOrientationTo")
                    : text("theToolTurnsEvenlyToThe"));
    blend(
        form,
        circle.blendRadiusM(),
        radius -> new MotionStep.CircleMove(circle.fixedOrientation(), radius));
    int points = context.node().children().size();
    return form.note(
            "points",
            Item.Tone.WARNING,
            points == 2 ? "" : text("itNeedsTwoWaypointsBelowIt", points))
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
    form.part(text("corner"))
        .either(
            "blend",
            text("here"),
            text("stop"),
            text("blend"),
            radiusM.isEmpty(),
            stop ->
                step.apply(
                    stop
                        ? OptionalDouble.empty()
                        : OptionalDouble.of(
                            kept.recall("blend", Double.class).orElse(field.initialValue()))));
    if (radiusM.isPresent()) {
      form.number(
          field,
          text("radius"),
          radiusM.getAsDouble(),
          value -> step.apply(OptionalDouble.of(value)));
    }
  }

  private static NodeForm until(FormContext context, UntilRule rule) {
    context.kept().keep(rule);
    FormBuilder form =
        new FormBuilder(context, "until", text("until"), text("endsTheWayEarlyTheNodes"));
    Kept kept = context.kept();
    form.part(text("endsWhen"))
        .sides(
            "rule",
            "",
            List.of(
                new Option("distance", text("distance")),
                new Option("contact", text("contact")),
                new Option("expression", text("expression")),
                new Option("input", text("input"))),
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
            text("distance"),
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
                  text("goBack"),
                  retractM,
                  value -> new MotionStep.Until(new UntilRule.Contact(value, decelerationMPerS2)))
              .number(
                  NodeFields.CONTACT_DECELERATION,
                  text("deceleration"),
                  decelerationMPerS2,
                  value -> new MotionStep.Until(new UntilRule.Contact(retractM, value)))
              .quiet("contact-hint", text("howFarTheToolGoesBack"));
      case UntilRule.Expression(String condition) ->
          form.condition(
              "rule.condition",
              text("condition"),
              condition,
              text("suchAsForceAbove"),
              value -> new MotionStep.Until(new UntilRule.Expression(value)));
      case UntilRule.DigitalInput(String signal, boolean level) ->
          form.choice(
                  "rule.signal",
                  text("input"),
                  context.signals().digitalInputs(),
                  signal,
                  text("isNoDigitalInput"),
                  value -> new MotionStep.Until(new UntilRule.DigitalInput(value, level)))
              .either(
                  "rule.level",
                  text("becomes"),
                  text("high"),
                  text("low"),
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
        new FormBuilder(context, "home", text("home"), text("movesAllJointsToTheHome"))
            .part(text("motion"))
            .number(
                NodeFields.HOME_SPEED,
                text("jointSpeed"),
                home.speedRadPerS(),
                context.usualSpeed(MoveKind.JOINT),
                value -> new MotionStep.Home(value, home.accelerationRadPerS2(), home.timeS()))
            .number(
                NodeFields.HOME_ACCELERATION,
                text("acceleration"),
                home.accelerationRadPerS2(),
                value -> new MotionStep.Home(home.speedRadPerS(), value, home.timeS()))
            .optional(
                NodeFields.HOME_TIME,
                text("time"),
                home.timeS(),
                text("bySpeed"),
                value ->
                    new MotionStep.Home(home.speedRadPerS(), home.accelerationRadPerS2(), value))
            .quiet("time-hint", text("withATimeSpeedAndAcceleration"));
    Joints at = context.installation().homeRad();
    Measure angle = ShownMeasure.of(Measure.DEGREE, context.host().poseForm());
    List<String> places = new ArrayList<>();
    for (int i = 0; i < Joints.COUNT; i++) {
      places.add(text(JOINTS.get(i), angle.text(at.get(i))));
    }
    return form.part(text("whereItIs"))
        .quiet("place", text("jointsIn", angle.symbol(), Messages.joined(places)))
        .build();
  }
}
