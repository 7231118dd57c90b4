package org.pendant.project.program;

import static org.pendant.project.program.ProgramTreeTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;

/**
 * Catalogue of the numbers in nodes: what each is called, its unit, its range, and what it is in a
 * new node. Where several kinds of a node read a component differently, a function gives the field.
 */
public final class NodeFields {
  private static final NumberRange WAYS = NumberRange.upTo(5);
  private static final NumberRange PLACES = NumberRange.of(1, 1_000_000);
  private static final NumberRange OFFSETS = NumberRange.within(1);
  private static final double FORCE_LIMIT = 10;
  private static final double TURN_RAD = Math.toRadians(20);
  private static final int FIRST_TURN = 3;
  private static final List<String> AXES = List.of("x", "y", "z", "rx", "ry", "rz");

  /** How fast the joint goes that has the longest way. */
  private static final NodeField JOINT_SPEED =
      new NodeField(
          "speed",
          text("speed"),
          FieldUnit.DEGREE_PER_S,
          NumberRange.upTo(2 * Math.PI),
          Math.toRadians(60));

  private static final NodeField JOINT_ACCELERATION =
      new NodeField(
          "acceleration",
          text("acceleration"),
          FieldUnit.DEGREE_PER_S2,
          NumberRange.upTo(40),
          Math.toRadians(80));

  private static final NodeField TOOL_SPEED =
      new NodeField("speed", text("speed"), FieldUnit.MILLIMETRE_PER_S, NumberRange.upTo(5), 0.25);

  private static final NodeField TOOL_ACCELERATION =
      new NodeField(
          "acceleration",
          text("acceleration"),
          FieldUnit.MILLIMETRE_PER_S2,
          NumberRange.upTo(150),
          1.2);

  /**
   * The way of a {@link MotionStep.Home} may have a time instead of a speed, of at most an hour.
   */
  public static final NodeField HOME_TIME =
      new NodeField("timeS", text("time"), FieldUnit.SECOND, NumberRange.upTo(3600), 0).optional();

  /** How fast the joints of a {@link MotionStep.Home} go. */
  public static final NodeField HOME_SPEED = JOINT_SPEED.named("speedRadPerS");

  /** Acceleration of the joints of a {@link MotionStep.Home}. */
  public static final NodeField HOME_ACCELERATION =
      JOINT_ACCELERATION.named("accelerationRadPerS2");

  /** How long a way with a {@link Timing.Duration} takes. */
  public static final NodeField WAYPOINT_TIME = HOME_TIME.named("timing.timeS").from(2);

  /** Radius of the corner at a waypoint, a circle's end or a pattern point that has one. */
  public static final NodeField BLEND_RADIUS =
      new NodeField(
          "blendRadiusM", text("blendRadius"), FieldUnit.MILLIMETRE, NumberRange.of(0, 10), 0.025);

  /** Radius of the corner at a {@link UntilRule.Distance} that has one. */
  public static final NodeField UNTIL_BLEND_RADIUS = BLEND_RADIUS.named("rule.blendRadiusM");

  /** Part of a {@link MotionStep.Direction} along x. */
  public static final NodeField DIRECTION_X = part("x", 0);

  /** Part of a {@link MotionStep.Direction} along y. */
  public static final NodeField DIRECTION_Y = part("y", 0);

  /** Part of a {@link MotionStep.Direction} along z. */
  public static final NodeField DIRECTION_Z = part("z", -1);

  /** Speed of the tool of a {@link MotionStep.Direction} that has its own. */
  public static final NodeField DIRECTION_SPEED = TOOL_SPEED.named("speedMPerS").optional();

  /** Acceleration of the tool of a {@link MotionStep.Direction} that has its own. */
  public static final NodeField DIRECTION_ACCELERATION =
      TOOL_ACCELERATION.named("accelerationMPerS2").optional();

  /** How far the tool goes, see {@link UntilRule.Distance}. */
  public static final NodeField UNTIL_DISTANCE =
      new NodeField(
          "rule.distanceM", text("distance"), FieldUnit.MILLIMETRE, NumberRange.upTo(10), 0.1);

  /** How far the tool goes back after a {@link UntilRule.Contact}. */
  public static final NodeField RETRACTION =
      new NodeField(
          "rule.retractM", text("retraction"), FieldUnit.MILLIMETRE, NumberRange.within(10), 0);

  /** How the tool stops at a {@link UntilRule.Contact}. */
  public static final NodeField CONTACT_DECELERATION =
      new NodeField(
          "rule.stopDecelerationMPerS2",
          text("deceleration"),
          FieldUnit.MILLIMETRE_PER_S2,
          NumberRange.upTo(150),
          3);

  /** How long a {@link WaitFor.Time} takes. */
  public static final NodeField WAIT_TIME =
      new NodeField("what.timeS", text("time"), FieldUnit.SECOND, NumberRange.of(0, 1e6), 0.01);

  /** How long a {@link Setting.Pulse} takes. */
  public static final NodeField PULSE_TIME =
      new NodeField("setting.timeS", text("time"), FieldUnit.SECOND, NumberRange.upTo(1000), 0.5);

  /** Mass of a {@link Setting.Payload}. */
  public static final NodeField PAYLOAD_MASS =
      new NodeField("setting.massKg", text("mass"), FieldUnit.KILOGRAM, NumberRange.of(0, 100), 1);

  /** Centre of gravity of a {@link Setting.Payload} along x of the flange. */
  public static final NodeField PAYLOAD_X = centre("setting.cogXM");

  /** Centre of gravity of a {@link Setting.Payload} along y of the flange. */
  public static final NodeField PAYLOAD_Y = centre("setting.cogYM");

  /** Centre of gravity of a {@link Setting.Payload} along z of the flange. */
  public static final NodeField PAYLOAD_Z = centre("setting.cogZM");

  /** How many places a {@link Pattern.Line} has. */
  public static final NodeField LINE_PLACES =
      new NodeField(
          "pattern.count",
          text("placesOfTheLine"),
          FieldUnit.COUNT,
          NumberRange.of(2, PLACES.max()),
          4);

  /** How many places a row of a pattern has. */
  public static final NodeField COLUMNS =
      new NodeField("pattern.columns", text("columns"), FieldUnit.COUNT, PLACES, 3);

  /** How many rows a layer of a pattern has. */
  public static final NodeField ROWS =
      new NodeField("pattern.rows", text("rows"), FieldUnit.COUNT, PLACES, 2);

  /** How many layers a {@link Pattern.Box} has. */
  public static final NodeField LAYERS =
      new NodeField("pattern.layers", text("layers"), FieldUnit.COUNT, PLACES, 2);

  /** Part of the direction of a {@link TemplateStep.Seek} along x. */
  public static final NodeField SEEK_X = part("direction.x", 0);

  /** Part of the direction of a {@link TemplateStep.Seek} along y. */
  public static final NodeField SEEK_Y = part("direction.y", 0);

  /** Part of the direction of a {@link TemplateStep.Seek} along z. */
  public static final NodeField SEEK_Z = part("direction.z", -1);

  /** How far a {@link TemplateStep.Seek} goes at most. */
  public static final NodeField SEEK_LIMIT =
      new NodeField("limitM", text("farthestWay"), FieldUnit.MILLIMETRE, WAYS, 0.3);

  /** How high an item of a {@link TemplateStep.Seek} is. */
  public static final NodeField ITEM_HEIGHT =
      new NodeField("itemHeightM", text("itemThickness"), FieldUnit.MILLIMETRE, WAYS, 0.02);

  /** How fast the tool of a {@link TemplateStep.Seek} goes. */
  public static final NodeField SEEK_SPEED = TOOL_SPEED.named("speedMPerS").from(0.05);

  /** Acceleration of the tool of a {@link TemplateStep.Seek}. */
  public static final NodeField SEEK_ACCELERATION = TOOL_ACCELERATION.named("accelerationMPerS2");

  /** After which time a {@link TemplateStep.Screwdriving} is an error; 0 for never. */
  public static final NodeField SCREW_TIMEOUT =
      new NodeField("timeoutS", text("time"), FieldUnit.SECOND, NumberRange.of(0, 3600), 0);

  private static final NodeField SCREW_FORCE =
      new NodeField("value", text("pressingForce"), FieldUnit.NEWTON, NumberRange.upTo(500), 20);

  private static final NodeField SCREW_SPEED =
      new NodeField("value", text("speed"), FieldUnit.MILLIMETRE_PER_S, NumberRange.upTo(1), 0.005);

  private NodeFields() {}

  private static NodeField part(String name, double initial) {
    return new NodeField(
        name, name.substring(name.length() - 1), FieldUnit.NUMBER, NumberRange.ANY, initial);
  }

  private static NodeField centre(String name) {
    return new NodeField(name, text("centreOfGravity"), FieldUnit.MILLIMETRE, OFFSETS, 0);
  }

  /** How fast a {@link MotionStep.Move} or {@link TemplateStep.PatternPoint} goes. */
  public static NodeField speed(MoveKind kind) {
    return kind == MoveKind.JOINT ? JOINT_SPEED : TOOL_SPEED;
  }

  /** Acceleration of a {@link MotionStep.Move} or {@link TemplateStep.PatternPoint}. */
  public static NodeField acceleration(MoveKind kind) {
    return kind == MoveKind.JOINT ? JOINT_ACCELERATION : TOOL_ACCELERATION;
  }

  /**
   * How fast a waypoint with a {@link Timing.Own} is gone to.
   *
   * @param kind of the move that it belongs to
   */
  public static NodeField waypointSpeed(MoveKind kind) {
    return speed(kind).named("timing.speed");
  }

  /**
   * Acceleration to a waypoint with a {@link Timing.Own}.
   *
   * @param kind of the move that it belongs to
   */
  public static NodeField waypointAcceleration(MoveKind kind) {
    return acceleration(kind).named("timing.acceleration");
  }

  /**
   * With which value a {@link WaitFor.Analog} compares a signal.
   *
   * @param signal such as {@code analog_in[0]}
   */
  public static NodeField waitLevel(String signal, Wiring wiring) {
    return level("what.value", domain(signal, wiring), 0.5, false);
  }

  /**
   * To which value a {@link Setting.Analog} sets a signal.
   *
   * @param signal such as {@code analog_out[0]}
   */
  public static NodeField analogOutput(String signal, Wiring wiring) {
    return level("setting.value", domain(signal, wiring), 0, true);
  }

  /** A field for an analog signal that is at first at a part of its range. */
  private static NodeField level(
      String name, Optional<AnalogDomain> domain, double ratio, boolean bounded) {
    if (domain.isEmpty()) {
      return new NodeField(name, text("value"), FieldUnit.NUMBER, NumberRange.ANY, 0);
    }
    AnalogDomain in = domain.get();
    boolean voltage = in == AnalogDomain.VOLTAGE;
    return new NodeField(
        name,
        text(voltage ? "voltage" : "current"),
        voltage ? FieldUnit.VOLT : FieldUnit.MILLIAMPERE,
        bounded ? NumberRange.of(in.low(), in.high()) : NumberRange.ANY,
        in.valueAt(ratio));
  }

  /** What an analog signal is; empty if it is none of the control box or the tool. */
  public static Optional<AnalogDomain> domain(String signal, Wiring wiring) {
    for (AnalogBank bank : AnalogBank.values()) {
      List<AnalogDomain> domains =
          switch (bank) {
            case STANDARD_IN -> wiring.analogIn();
            case STANDARD_OUT -> wiring.analogOut();
            case TOOL_IN -> wiring.toolAnalogIn();
          };
      for (int i = 0; i < AnalogBank.SIZE; i++) {
        if (bank.name(i).equals(signal)) {
          return Optional.of(domains.get(i));
        }
      }
    }
    return Optional.empty();
  }

  /**
   * A number of the pose of a {@link Setting.Tcp}.
   *
   * @param axis 0 to 5: x, y, z and the rotation vector
   */
  public static NodeField tcp(int axis) {
    return ofPose("setting.pose-" + AXES.get(axis), axis);
  }

  /**
   * A number of the pose of a place that was taught.
   *
   * @param axis 0 to 5: x, y, z and the rotation vector
   */
  public static NodeField placePose(int axis) {
    return ofPose("pose-" + AXES.get(axis), axis);
  }

  private static NodeField ofPose(String name, int axis) {
    return new NodeField(
        name,
        AXES.get(axis),
        axis < FIRST_TURN ? FieldUnit.MILLIMETRE : FieldUnit.DEGREE,
        NumberRange.ANY,
        0);
  }

  /**
   * A joint position of a place that was taught.
   *
   * @param joint 0 to 5
   */
  public static NodeField placeJoint(int joint) {
    return new NodeField(
        "joint-" + joint, text("joint", joint), FieldUnit.DEGREE, NumberRange.ANY, 0);
  }

  /**
   * Force along or torque about an axis of a {@link TemplateStep.Force} that is compliant.
   *
   * @param axis 0 to 5
   */
  public static NodeField wrench(int axis) {
    boolean line = axis < FIRST_TURN;
    return new NodeField(
        "wrench." + axis,
        text(line ? "forceAlong" : "torqueAbout", AXES.get(axis)),
        line ? FieldUnit.NEWTON : FieldUnit.NEWTON_METRE,
        NumberRange.within(line ? 500 : 100),
        0);
  }

  /**
   * How fast an axis of a {@link TemplateStep.Force} may give way that is compliant, or how far
   * another one may be off.
   *
   * @param axis 0 to 5
   */
  public static NodeField forceLimit(int axis, boolean compliant) {
    boolean line = axis < FIRST_TURN;
    String name = "limits." + axis;
    return compliant
        ? new NodeField(
            name,
            text("speedLimitOf", AXES.get(axis)),
            line ? FieldUnit.MILLIMETRE_PER_S : FieldUnit.DEGREE_PER_S,
            NumberRange.upTo(FORCE_LIMIT),
            line ? 0.15 : TURN_RAD)
        : new NodeField(
            name,
            text("deviationLimitOf", AXES.get(axis)),
            line ? FieldUnit.MILLIMETRE : FieldUnit.DEGREE,
            NumberRange.of(0, FORCE_LIMIT),
            line ? 0.1 : TURN_RAD);
  }

  /** Force or speed with which a {@link TemplateStep.Screwdriving} follows the screw. */
  public static NodeField screwValue(boolean byForce) {
    return byForce ? SCREW_FORCE : SCREW_SPEED;
  }
}
