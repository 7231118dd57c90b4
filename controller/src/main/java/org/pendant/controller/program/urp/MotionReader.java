package org.pendant.controller.program.urp;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.packedxml.UnreadableFile;
import org.pendant.controller.packedxml.XmlElement;
import org.pendant.controller.program.MotionStep;
import org.pendant.controller.program.MoveKind;
import org.pendant.controller.program.Step;
import org.pendant.controller.program.Timing;
import org.pendant.controller.program.ToolChoice;
import org.pendant.controller.program.UntilRule;
import org.pendant.controller.program.WaypointTarget;

/** Understands the elements that move the arm. */
final class MotionReader {
  static final String DIRECTION = "gui.program.direction.MoveDirectionNode";

  private static final double JOINT_SPEED_RAD_PER_S = Math.toRadians(60);
  private static final double JOINT_ACCELERATION_RAD_PER_S2 = Math.toRadians(80);
  private static final double TOOL_SPEED_M_PER_S = 0.25;
  private static final double TOOL_ACCELERATION_M_PER_S2 = 1.2;
  private static final double STOP_M_PER_S2 = 3;
  private static final Pattern AXIS =
      Pattern.compile("(^|[^A-Z])([XYZ])[^A-Z]*(\\+|-|PLUS|MINUS|POS|NEG)");

  private final Expressions expressions;
  private final UrpSignals signals;
  private final Positions positions;
  private final Remarks remarks;

  MotionReader(Expressions expressions, UrpSignals signals, Positions positions, Remarks remarks) {
    this.expressions = expressions;
    this.signals = signals;
    this.positions = positions;
    this.remarks = remarks;
  }

  /** The step of an element; empty if it is none of these. */
  Optional<Step> step(XmlElement element, Within within) throws UnreadableFile {
    return switch (Values.kind(element)) {
      case "Move" -> Optional.of(move(element));
      case "Waypoint" -> waypoint(element, within);
      case "CircleMove" ->
          Optional.of(
              new MotionStep.CircleMove(
                  element.text("OrientationMode").toLowerCase(Locale.ROOT).startsWith("fix"),
                  blend(element)));
      case DIRECTION -> direction(element);
      case "Until" -> until(element).map(MotionStep.Until::new);
      case "SafeHome" -> Optional.of(home(element));
      default -> Optional.empty();
    };
  }

  /** What a move says of the nodes in it. */
  Within inside(XmlElement element, Step step, Within around) {
    return switch (step) {
      case MotionStep.Move move ->
          new Within(
              move.kind(),
              move.speed(),
              move.acceleration(),
              move.feature(),
              Values.attribute(element, "blendRadius"));
      // the corner of a circle is its own
      case MotionStep.CircleMove _ -> around.without();
      default -> around;
    };
  }

  private MotionStep.Move move(XmlElement element) throws UnreadableFile {
    MoveKind kind =
        switch (element.text("motionType")) {
          case "MoveL" -> MoveKind.LINEAR;
          case "MoveP" -> MoveKind.PROCESS;
          default -> MoveKind.JOINT;
        };
    boolean joint = kind == MoveKind.JOINT;
    double speed =
        Values.attribute(element, "speed")
            .orElse(joint ? JOINT_SPEED_RAD_PER_S : TOOL_SPEED_M_PER_S);
    double acceleration =
        Values.attribute(element, "acceleration")
            .orElse(joint ? JOINT_ACCELERATION_RAD_PER_S2 : TOOL_ACCELERATION_M_PER_S2);
    return new MotionStep.Move(
        kind,
        speed,
        acceleration,
        tool(element),
        Features.in(element, expressions),
        element.text("positionType").equals("JointAngles"));
  }

  private ToolChoice tool(XmlElement element) throws UnreadableFile {
    Optional<XmlElement> tcp = element.child("tcp");
    String name = tcp.isEmpty() ? "" : expressions.name(tcp.get());
    if (element.attribute("useActiveTCP").orElse("true").equals("true")) {
      return new ToolChoice.Active();
    }
    return tcp.isEmpty() ? new ToolChoice.Flange() : new ToolChoice.Named(name);
  }

  private Optional<Step> waypoint(XmlElement element, Within within) throws UnreadableFile {
    Optional<WaypointTarget> target = target(element, within);
    if (target.isEmpty()) {
      return Optional.empty();
    }
    Optional<XmlElement> carrier = element.child("motionParameters");
    Optional<XmlElement> parameters = carrier.isEmpty() ? carrier : carrier.get().resolved();
    OptionalDouble blend = parameters.map(MotionReader::blend).orElse(OptionalDouble.empty());
    return Optional.of(
        new MotionStep.Waypoint(
            target.get(),
            parameters.map(each -> timing(each, within)).orElse(new Timing.AsMove()),
            blend.isPresent() ? blend : within.blendRadiusM()));
  }

  private Optional<WaypointTarget> target(XmlElement element, Within within) throws UnreadableFile {
    String name = element.text("name");
    return switch (element.text("type")) {
      case "Fixed" -> {
        positions.add(name, element, within.feature());
        yield Optional.of(new WaypointTarget.Fixed(name));
      }
      case "Variable" -> {
        String expression = expressions.in(element);
        yield Optional.of(
            new WaypointTarget.Variable(
                expression.isEmpty() ? expressions.variable(element) : expression));
      }
      case "Relative" -> relative(name, element, within);
      default -> Optional.empty();
    };
  }

  /** Two places stand in it, from and to; how they are called is not known for certain. */
  private Optional<WaypointTarget> relative(String name, XmlElement element, Within within)
      throws UnreadableFile {
    List<XmlElement> places = new ArrayList<>();
    for (XmlElement each : element.children()) {
      if (each.name().toLowerCase(Locale.ROOT).endsWith("position")) {
        places.add(each);
      }
    }
    if (places.size() != 2) {
      return Optional.empty();
    }
    String from = name + "_from";
    String to = name + "_to";
    positions.add(from, element, places.get(0), within.feature());
    positions.add(to, element, places.get(1), within.feature());
    return Optional.of(new WaypointTarget.Relative(name, from, to));
  }

  private static OptionalDouble blend(XmlElement element) {
    return Values.attribute(element, "blendRadius");
  }

  private static Timing timing(XmlElement parameters, Within within) {
    OptionalDouble time = Values.attribute(parameters, "time");
    boolean joint = within.kind() == MoveKind.JOINT;
    OptionalDouble speed = Values.attribute(parameters, joint ? "jointSpeed" : "cartesianSpeed");
    OptionalDouble acceleration =
        Values.attribute(parameters, joint ? "jointAcceleration" : "cartesianAcceleration");
    // Those of the other sort of move are often there as well, and mean nothing.
    for (String each :
        List.of("jointSpeed", "jointAcceleration", "cartesianSpeed", "cartesianAcceleration")) {
      var _ = parameters.attribute(each);
    }
    if (time.isPresent()) {
      return new Timing.Duration(time.getAsDouble());
    }
    return speed.isEmpty() && acceleration.isEmpty()
        ? new Timing.AsMove()
        : new Timing.Own(speed.orElse(within.speed()), acceleration.orElse(within.acceleration()));
  }

  private Optional<Step> direction(XmlElement element) throws UnreadableFile {
    Matcher axis = AXIS.matcher(element.text("selectedDirection").toUpperCase(Locale.ROOT));
    if (!axis.find()) {
      return Optional.empty();
    }
    double sign = axis.group(3).startsWith("-") || axis.group(3).matches("MINUS|NEG") ? -1 : 1;
    Optional<XmlElement> parameters = element.child("motionParameters");
    OptionalDouble none = OptionalDouble.empty();
    return Optional.of(
        new MotionStep.Direction(
            Features.in(element, expressions),
            axis.group(2).equals("X") ? sign : 0,
            axis.group(2).equals("Y") ? sign : 0,
            axis.group(2).equals("Z") ? sign : 0,
            parameters.map(each -> Values.attribute(each, "cartesianSpeed")).orElse(none),
            parameters.map(each -> Values.attribute(each, "cartesianAcceleration")).orElse(none)));
  }

  private Optional<UntilRule> until(XmlElement element) throws UnreadableFile {
    String type = element.text("type").toUpperCase(Locale.ROOT);
    Optional<XmlElement> distance = element.child("Distance", "distance");
    if (distance.isPresent()) {
      OptionalDouble metres = Values.number(distance.get().text());
      return metres.isEmpty()
          ? Optional.empty()
          : Optional.of(new UntilRule.Distance(metres.getAsDouble()));
    }
    if (element.child("pin").isPresent()) {
      return Optional.of(
          new UntilRule.DigitalInput(signals.in(element), Values.yes(element, "digitalValue")));
    }
    if (element.child("expression").isPresent()) {
      return Optional.of(new UntilRule.Expression(expressions.in(element)));
    }
    if (!type.contains("CONTACT")) {
      return Optional.empty();
    }
    remarks.add(element, "how far the tool goes back after a contact is read by guess");
    return Optional.of(
        new UntilRule.Contact(
            like(element, "retract", 0), like(element, "deceler", STOP_M_PER_S2)));
  }

  /** The number of the first attribute or element whose name has a word in it. */
  private static double like(XmlElement element, String word, double otherwise) {
    for (String name : element.attributeNames()) {
      if (name.toLowerCase(Locale.ROOT).contains(word)) {
        return Values.attribute(element, name).orElse(otherwise);
      }
    }
    for (XmlElement each : element.children()) {
      if (each.name().toLowerCase(Locale.ROOT).contains(word)) {
        return Values.number(each.text()).orElse(otherwise);
      }
    }
    return otherwise;
  }

  private static MotionStep.Home home(XmlElement element) {
    boolean byTime = element.text("positionOptionType").toUpperCase(Locale.ROOT).contains("TIME");
    OptionalDouble time = Values.attribute(element, "time");
    return new MotionStep.Home(
        Values.attribute(element, "speed").orElse(JOINT_SPEED_RAD_PER_S),
        Values.attribute(element, "acceleration").orElse(JOINT_ACCELERATION_RAD_PER_S2),
        byTime ? time : OptionalDouble.empty());
  }
}
