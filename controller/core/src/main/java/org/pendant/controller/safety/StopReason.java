package org.pendant.controller.safety;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.OptionalInt;

/**
 * Stop reason: everything that stops the arm or warns, with its code and words; docs/safety.md has
 * the same table. Codes 153, 157, 173, 204 and 209 are those of the real controller; the others are
 * not published and are our choice.
 */
public enum StopReason {
  JOINT_LIMIT_NEAR(150, Kind.PROTECTIVE, "comes too close to its position limit", "rad"),
  TOOL_DIRECTION_NEAR(151, Kind.PROTECTIVE, "comes too close to its largest tilt", "rad"),
  PLANE_NEAR(152, Kind.PROTECTIVE, "comes too close to safety plane", "m"),
  POSITION_DEVIATION(153, Kind.PROTECTIVE, "is away from its target", "rad"),
  FORCE_MODE_SHIFT(153, Kind.PROTECTIVE, "is away from its path along", "m"),
  FORCE_MODE_TURN(153, Kind.PROTECTIVE, "is turned away from its path about", "rad"),
  SINGULARITY(154, 0, Kind.PROTECTIVE, "", ""),
  WRONG_PAYLOAD(
      155, 0, Kind.PROTECTIVE, "is not what the flange carries, or something pushes the tool", "N"),
  COLLISION(157, Kind.PROTECTIVE, "is pushed from outside", "Nm"),
  LINK_HIT(157, Kind.PROTECTIVE, "", "m"),
  OUT_OF_REACH(200, 0, Kind.PROTECTIVE, "", ""),
  TARGET_POSITION_JUMP(204, 1, Kind.PROTECTIVE, "has a target position that jumps", "rad"),
  TARGET_SPEED_JUMP(204, 3, Kind.PROTECTIVE, "has a target speed that jumps", "rad/s"),
  PROGRAM(209, 0, Kind.PROTECTIVE, "asks for it", ""),

  ROBOT_EMERGENCY_STOP(100, Kind.ROBOT_EMERGENCY, "is active", ""),
  SYSTEM_EMERGENCY_STOP(100, Kind.SYSTEM_EMERGENCY, "is active", ""),
  SAFEGUARD_STOP(100, Kind.SAFEGUARD, "is active", ""),
  AUTOMATIC_MODE_SAFEGUARD_STOP(100, Kind.AUTOMATIC_SAFEGUARD, "is active", ""),

  JOINT_POSITION(191, 0, Kind.VIOLATION, "is beyond its position limit", "rad"),
  JOINT_SPEED(191, 1, Kind.VIOLATION, "turns too fast", "rad/s"),
  TOOL_SPEED(191, 2, Kind.VIOLATION, "moves too fast", "m/s"),
  ELBOW_SPEED(191, 3, Kind.VIOLATION, "moves too fast", "m/s"),
  MOMENTUM(191, 4, Kind.VIOLATION, "has too much momentum", "kg m/s"),
  POWER(191, 5, Kind.VIOLATION, "does too much work on its surroundings", "W"),
  TOOL_FORCE(191, 6, Kind.VIOLATION, "is pressed too hard", "N"),
  ELBOW_FORCE(191, 7, Kind.VIOLATION, "is pressed too hard", "N"),
  PLANE(191, 8, Kind.VIOLATION, "is beyond safety plane", "m"),
  TOOL_DIRECTION(191, 9, Kind.VIOLATION, "is tilted too far", "rad"),

  NO_READING(192, 0, Kind.FAULT, "reports no number", ""),

  DEVIATION_WARNING(173, Kind.WARNING, "is away from its target", "rad");

  /** Names of the joints, base first. */
  private static final List<String> JOINT_NAMES =
      List.of("base", "shoulder", "elbow", "wrist 1", "wrist 2", "wrist 3");

  /** Digits of a measured number in a message: enough to tell it from its limit. */
  private static final MathContext DIGITS = new MathContext(5);

  /** What comes of it. */
  private enum Kind {
    PROTECTIVE("protective stop", SafetyMode.PROTECTIVE_STOP, StopCategory.TWO),
    ROBOT_EMERGENCY("emergency stop", SafetyMode.ROBOT_EMERGENCY_STOP, StopCategory.ONE),
    SYSTEM_EMERGENCY("emergency stop", SafetyMode.SYSTEM_EMERGENCY_STOP, StopCategory.ONE),
    SAFEGUARD("safeguard stop", SafetyMode.SAFEGUARD_STOP, StopCategory.TWO),
    AUTOMATIC_SAFEGUARD(
        "safeguard stop", SafetyMode.AUTOMATIC_MODE_SAFEGUARD_STOP, StopCategory.TWO),
    VIOLATION("violation", SafetyMode.VIOLATION, StopCategory.ZERO),
    FAULT("fault", SafetyMode.FAULT, StopCategory.ZERO),
    /** Stops nothing; mode and category are not used. */
    WARNING("warning", SafetyMode.NORMAL, StopCategory.TWO);

    final String word;
    final SafetyMode mode;
    final StopCategory category;

    Kind(String word, SafetyMode mode, StopCategory category) {
      this.word = word;
      this.mode = mode;
      this.category = category;
    }
  }

  /** Stands for an argument that differs from case to case. */
  private static final int VARIES = -1;

  private final int code;
  private final int argument;
  private final Kind kind;
  private final String words;
  private final String unit;

  StopReason(int code, Kind kind, String words, String unit) {
    this(code, VARIES, kind, words, unit);
  }

  StopReason(int code, int argument, Kind kind, String words, String unit) {
    this.code = code;
    this.argument = argument;
    this.kind = kind;
    this.words = words;
    this.unit = unit;
  }

  /** Code of the error, the x of CxAy. */
  public int code() {
    return code;
  }

  /** The safety mode while such a stop lasts. */
  SafetyMode mode() {
    return kind.mode;
  }

  /** A stop because of joint {@code joint}, 0 to 5; the joint is the argument where that varies. */
  SafetyStop ofJoint(int joint, double timeS, double value, double limit) {
    String subject = JOINT_NAMES.get(joint) + " (joint " + joint + ") " + words;
    return stop(subject, joint, OptionalInt.of(joint), timeS, value, limit);
  }

  /** A stop because of something that was measured. */
  SafetyStop of(String subject, double timeS, double value, double limit) {
    return stop(subject + " " + words, 0, OptionalInt.empty(), timeS, value, limit);
  }

  /** A stop because of the plane with this number in the configuration, from 0. */
  SafetyStop ofPlane(
      String subject, SafetyPlane plane, int number, double timeS, double value, double limit) {
    String sentence = subject + " " + words + " \"" + plane.name() + "\"";
    return stop(sentence, number, OptionalInt.empty(), timeS, value, limit);
  }

  /**
   * A stop because of the TCP and an axis of force mode's task frame.
   *
   * @param joint the argument, and the joint that it is about, 0 to 5
   */
  SafetyStop alongAxis(char axis, int joint, double timeS, double value, double limit) {
    String sentence = "the TCP " + words + " " + axis + " of the task frame of force mode";
    return stop(sentence, joint, OptionalInt.of(joint), timeS, value, limit);
  }

  /**
   * A stop because of a link of the arm that is in something.
   *
   * @param sentence which link, and what it is in
   * @param joint that moves the link, 0 to 5
   */
  SafetyStop ofLink(String sentence, int joint, double timeS, double depthM) {
    return stop(sentence, joint, OptionalInt.of(joint), timeS, depthM, 0);
  }

  /** A stop because of an input, or on request. */
  SafetyStop of(String subject, double timeS) {
    return stop(subject + " " + words, kind.mode.code(), OptionalInt.empty(), timeS, 0, 0);
  }

  /** A stop because a path cannot be followed, in words that have what was measured. */
  SafetyStop because(String sentence, OptionalInt joint, double timeS) {
    return stop(sentence, joint.orElse(0), joint, timeS, 0, 0, "");
  }

  private SafetyStop stop(
      String sentence, int varying, OptionalInt joint, double timeS, double value, double limit) {
    return stop(sentence, varying, joint, timeS, value, limit, unit);
  }

  private SafetyStop stop(
      String sentence,
      int varying,
      OptionalInt joint,
      double timeS,
      double value,
      double limit,
      String measuredIn) {
    int chosen = argument == VARIES ? varying : argument;
    StringBuilder message = new StringBuilder();
    message.append('C').append(code).append('A').append(chosen).append(' ');
    message
        .append(kind.word)
        .append(" at ")
        .append(milliseconds(timeS))
        .append(" s: ")
        .append(sentence);
    if (!measuredIn.isEmpty()) {
      message.append(": ").append(number(value)).append(' ').append(measuredIn);
      message.append(", limit ").append(number(limit)).append(' ').append(measuredIn);
    }
    return new SafetyStop(
        kind.mode,
        kind.category,
        code,
        chosen,
        joint,
        timeS,
        value,
        limit,
        measuredIn,
        message.toString());
  }

  private static BigDecimal milliseconds(double timeS) {
    return BigDecimal.valueOf(Math.round(timeS * 1000), 3);
  }

  private static String number(double value) {
    return Double.isFinite(value)
        ? new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString()
        : Double.toString(value);
  }
}
