package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.Step;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaypointTarget;

/** Motion reader: understands the elements that move the arm. */
final class MotionReader {
  static final String DIRECTION = "gui.program.direction.MoveDirectionNode";

  /** Of a direction: speed and acceleration in place of those of the move. */
  static final String OWN_SPEEDS = "toolParams";

  /** Of a direction along an axis. */
  static final String AXIS_NAME = "selectedDirection";

  static final String UNTIL_TYPE = "type";
  static final String CONTACT = "TOOL_CONTACT_DETECTION";
  static final String RETRACTION = "retraction";
  static final String CONTACT_STOP = "decelerationAcceleration";
  static final String DISTANCE = "Distance";
  static final String DISTANCE_ENDS = "distanceNodeType";
  static final String BLENDS = "BLEND";

  /** How long a way takes, s. */
  static final String MOTION_TIME = "nextMotionTime";

  /** Where a relative way begins and ends. */
  static final String FROM = "relativeFromPosition";

  static final String TO = "position";

  private static final String MOTION_TYPE = "motionType";
  private static final String PROCESS = "MoveP";
  private static final String WAYPOINT = "Waypoint";
  private static final String CIRCLE = "CircleMove";

  /** What moves the arm in a move; others stand between them, also such that are switched off. */
  private static final Set<String> WAYS = Set.of(WAYPOINT, CIRCLE, DIRECTION);

  private static final OptionalDouble NONE = OptionalDouble.empty();
  private static final Pattern AXIS = Pattern.compile("([XYZ])(Plus|Minus)");

  private final ExpressionReader expressions;
  private final UrpSignals signals;
  private final Positions positions;
  private final Remarks remarks;

  MotionReader(
      ExpressionReader expressions, UrpSignals signals, Positions positions, Remarks remarks) {
    this.expressions = expressions;
    this.signals = signals;
    this.positions = positions;
    this.remarks = remarks;
  }

  /** The step of an element; empty if it is none of these. */
  Optional<Step> step(XmlElement element, Within within) throws UnreadableFile {
    return switch (SwitchedOff.kind(element)) {
      case "Move" -> Optional.of(move(element));
      case WAYPOINT -> waypoint(element, within);
      case CIRCLE ->
          Optional.of(
              new MotionStep.CircleMove(
                  element.text("OrientationMode").toLowerCase(Locale.ROOT).startsWith("fix"),
                  within.blend(blend(element))));
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
              blend(element),
              around.lastOfProcess());
      // the corner of a circle is its own
      case MotionStep.CircleMove _ -> around.without();
      default -> around;
    };
  }

  /** Whether the first way of it leads to a waypoint, and not as a process move. */
  static boolean isOtherMove(XmlElement element) {
    return element.name().equals("Move")
        && !element.text(MOTION_TYPE).equals(PROCESS)
        && element.child("children").stream()
            .flatMap(each -> each.children().stream())
            .map(XmlElement::name)
            .filter(WAYS::contains)
            .findFirst()
            .filter(WAYPOINT::equals)
            .isPresent();
  }

  private MotionStep.Move move(XmlElement element) throws UnreadableFile {
    MoveKind kind =
        switch (element.text(MOTION_TYPE)) {
          case "MoveL" -> MoveKind.LINEAR;
          case PROCESS -> MoveKind.PROCESS;
          default -> MoveKind.JOINT;
        };
    optimal(element);
    double speed = Values.attribute(element, "speed").orElse(NodeFields.speed(kind).initialValue());
    double acceleration =
        Values.attribute(element, "acceleration")
            .orElse(NodeFields.acceleration(kind).initialValue());
    return new MotionStep.Move(
        kind,
        speed,
        acceleration,
        tool(element),
        Features.in(element, expressions),
        element.text("positionType").equals("JointAngles"));
  }

  /** Shares of what the arm can do, which stand there even where they are not wanted. */
  private void optimal(XmlElement element) {
    for (String each : List.of("optiMoveSpeed", "optiMoveAcceleration")) {
      var _ = element.attribute(each);
    }
    if (element.text("optimoveEnabled").equals("true")) {
      remarks.add(element, text("optiMove"));
    }
  }

  private ToolChoice tool(XmlElement element) throws UnreadableFile {
    Optional<XmlElement> tcp = element.child("tcp");
    String name = tcp.isEmpty() ? "" : expressions.name(tcp.get());
    if (element.attribute("useActiveTCP").orElse("true").equals("true")) {
      return new ToolChoice.Active();
    }
    if (tcp.isEmpty()) {
      return new ToolChoice.Flange();
    }
    positions.addTool(name, element);
    return new ToolChoice.Named(name);
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
            within.blend(blend)));
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

  private Optional<WaypointTarget> relative(String name, XmlElement element, Within within)
      throws UnreadableFile {
    Optional<XmlElement> start = element.child(FROM);
    Optional<XmlElement> end = element.child(TO);
    if (start.isEmpty() || end.isEmpty()) {
      return Optional.empty();
    }
    String from = name + "_from";
    String to = name + "_to";
    positions.add(from, element, start.get(), within.feature());
    positions.add(to, element, end.get(), within.feature());
    return Optional.of(new WaypointTarget.Relative(name, from, to));
  }

  private static OptionalDouble blend(XmlElement element) {
    return Values.attribute(element, "blendRadius");
  }

  private static Timing timing(XmlElement parameters, Within within) {
    boolean joint = within.kind() == MoveKind.JOINT;
    OptionalDouble speed = Values.attribute(parameters, joint ? "jointSpeed" : "cartesianSpeed");
    OptionalDouble acceleration =
        Values.attribute(parameters, joint ? "jointAcceleration" : "cartesianAcceleration");
    // Those of the other sort of move are often there as well, and mean nothing.
    for (String each :
        List.of("jointSpeed", "jointAcceleration", "cartesianSpeed", "cartesianAcceleration")) {
      var _ = parameters.attribute(each);
    }
    // a process move has one speed for all of its way
    OptionalDouble time =
        within.kind() == MoveKind.PROCESS
            ? OptionalDouble.empty()
            : Values.attribute(parameters, MOTION_TIME);
    if (time.isPresent()) {
      return new Timing.Duration(time.getAsDouble());
    }
    return speed.isEmpty() && acceleration.isEmpty()
        ? new Timing.AsMove()
        : new Timing.Own(speed.orElse(within.speed()), acceleration.orElse(within.acceleration()));
  }

  private Optional<Step> direction(XmlElement element) throws UnreadableFile {
    String feature = Features.in(element, expressions);
    double[] own = Values.numbers(element.text(OWN_SPEEDS));
    OptionalDouble speed = own.length == 2 ? OptionalDouble.of(own[0]) : NONE;
    OptionalDouble acceleration = own.length == 2 ? OptionalDouble.of(own[1]) : NONE;
    String expression = expressions.in(element);
    double[] vector = expression.isEmpty() ? axis(element) : literal(expression);
    if (vector.length == 3) {
      return Optional.of(
          new MotionStep.Direction(feature, vector[0], vector[1], vector[2], speed, acceleration));
    }
    return expression.isEmpty()
        ? Optional.empty()
        : Optional.of(new MotionStep.Direction(feature, 0, 0, 0, expression, speed, acceleration));
  }

  /** The direction of an axis, such as {@code ZMinus}; nothing if it names none. */
  private static double[] axis(XmlElement element) {
    Matcher axis = AXIS.matcher(element.text(AXIS_NAME));
    if (!axis.matches()) {
      return new double[0];
    }
    double[] vector = new double[3];
    vector["XYZ".indexOf(axis.group(1))] = axis.group(2).equals("Minus") ? -1 : 1;
    return vector;
  }

  /** A list of numbers; nothing if it is another expression. */
  private static double[] literal(String expression) {
    return expression.startsWith("[") && expression.endsWith("]")
        ? Values.numbers(expression.substring(1, expression.length() - 1))
        : new double[0];
  }

  private Optional<UntilRule> until(XmlElement element) throws UnreadableFile {
    // whether there are nodes below it, which shows there
    var _ = element.attribute("allowActions");
    String type = element.text(UNTIL_TYPE);
    Optional<XmlElement> distance = element.child(DISTANCE);
    if (distance.isPresent()) {
      return distance(element, distance.get());
    }
    if (element.child("pin").isPresent()) {
      return Optional.of(
          new UntilRule.DigitalInput(signals.in(element), Values.yes(element, "digitalValue")));
    }
    if (element.child("expression").isPresent()) {
      return Optional.of(new UntilRule.Expression(expressions.in(element)));
    }
    if (!type.equals(CONTACT)) {
      return Optional.empty();
    }
    // how fast the tool stops turning, which it does not do on a straight way
    var _ = element.attribute("decelerationAngularAcceleration");
    return Optional.of(
        new UntilRule.Contact(
            Values.attribute(element, RETRACTION).orElse(NodeFields.RETRACTION.initialValue()),
            Values.attribute(element, CONTACT_STOP)
                .orElse(NodeFields.CONTACT_DECELERATION.initialValue())));
  }

  /** The way ends exactly there, so that its deceleration is that of the move. */
  private static Optional<UntilRule> distance(XmlElement element, XmlElement distance) {
    var _ = element.attribute("deceleration");
    // the radius stands there in any case
    OptionalDouble radiusM =
        element.child("motionParameters").map(MotionReader::blend).orElse(NONE);
    boolean blends = element.text(DISTANCE_ENDS).equals(BLENDS);
    OptionalDouble metres = Values.number(distance.text());
    return metres.isEmpty()
        ? Optional.empty()
        : Optional.of(new UntilRule.Distance(metres.getAsDouble(), blends ? radiusM : NONE));
  }

  private static MotionStep.Home home(XmlElement element) {
    boolean byTime = element.text("positionOptionType").toUpperCase(Locale.ROOT).contains("TIME");
    OptionalDouble time = Values.attribute(element, MOTION_TIME);
    return new MotionStep.Home(
        Values.attribute(element, "speed").orElse(NodeFields.HOME_SPEED.initialValue()),
        Values.attribute(element, "acceleration")
            .orElse(NodeFields.HOME_ACCELERATION.initialValue()),
        byTime ? time : OptionalDouble.empty());
  }
}
