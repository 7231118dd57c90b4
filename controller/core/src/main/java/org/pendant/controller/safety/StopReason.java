package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;
import java.util.OptionalInt;

/**
 * Stop reason: everything that stops the arm or warns, with its code and words; docs/safety.md has
 * the same table. Codes 153, 157, 173, 204 and 209 are those of the real controller; the others are
 * not published and are our choice.
 */
public enum StopReason {
  JOINT_LIMIT_NEAR(150, Kind.PROTECTIVE, "jointLimitNear", "rad"),
  TOOL_DIRECTION_NEAR(151, Kind.PROTECTIVE, "tiltNear", "rad"),
  PLANE_NEAR(152, Kind.PROTECTIVE, "planeNear", "m"),
  POSITION_DEVIATION(153, Kind.PROTECTIVE, "awayFromTarget", "rad"),
  FORCE_MODE_SHIFT(153, Kind.PROTECTIVE, "awayFromPath", "m"),
  FORCE_MODE_TURN(153, Kind.PROTECTIVE, "turnedAwayFromPath", "rad"),
  SINGULARITY(154, 0, Kind.PROTECTIVE, "", ""),
  WRONG_PAYLOAD(155, 0, Kind.PROTECTIVE, "wrongPayload", "N"),
  COLLISION(157, Kind.PROTECTIVE, "pushed", "Nm"),
  LINK_HIT(157, Kind.PROTECTIVE, "", "m"),
  OUT_OF_REACH(200, 0, Kind.PROTECTIVE, "", ""),
  TARGET_POSITION_JUMP(204, 1, Kind.PROTECTIVE, "targetPositionJumps", "rad"),
  TARGET_SPEED_JUMP(204, 3, Kind.PROTECTIVE, "targetSpeedJumps", "rad/s"),
  PROGRAM(209, 0, Kind.PROTECTIVE, "programAsks", ""),

  ROBOT_EMERGENCY_STOP(100, Kind.ROBOT_EMERGENCY, "inputActive", ""),
  SYSTEM_EMERGENCY_STOP(100, Kind.SYSTEM_EMERGENCY, "inputActive", ""),
  SAFEGUARD_STOP(100, Kind.SAFEGUARD, "inputActive", ""),
  AUTOMATIC_MODE_SAFEGUARD_STOP(100, Kind.AUTOMATIC_SAFEGUARD, "inputActive", ""),

  JOINT_POSITION(191, 0, Kind.VIOLATION, "jointBeyondLimit", "rad"),
  JOINT_SPEED(191, 1, Kind.VIOLATION, "jointTooFast", "rad/s"),
  TOOL_SPEED(191, 2, Kind.VIOLATION, "toolTooFast", "m/s"),
  ELBOW_SPEED(191, 3, Kind.VIOLATION, "elbowTooFast", "m/s"),
  MOMENTUM(191, 4, Kind.VIOLATION, "tooMuchMomentum", "kg m/s"),
  POWER(191, 5, Kind.VIOLATION, "tooMuchWork", "W"),
  TOOL_FORCE(191, 6, Kind.VIOLATION, "toolPressed", "N"),
  ELBOW_FORCE(191, 7, Kind.VIOLATION, "elbowPressed", "N"),
  PLANE(191, 8, Kind.VIOLATION, "beyondPlane", "m"),
  TOOL_DIRECTION(191, 9, Kind.VIOLATION, "tilted", "rad"),

  NO_READING(192, 0, Kind.FAULT, "noReading", ""),

  DEVIATION_WARNING(173, Kind.WARNING, "awayFromTarget", "rad");

  /** Keys of the joints' names, base first. */
  private static final List<String> JOINTS =
      List.of("base", "shoulder", "elbow", "wrist1", "wrist2", "wrist3");

  /** Digits of a measured number in a message, where these tell it from its limit. */
  private static final int DIGITS = 4;

  private static final int MAX_DIGITS = 12;

  /** So many more decimals than digits has a number at most: a micrometre says all. */
  private static final int LEADING_ZEROS = 2;

  /** What comes of it. */
  private enum Kind {
    PROTECTIVE("protectiveStop", SafetyMode.PROTECTIVE_STOP, StopCategory.TWO),
    ROBOT_EMERGENCY("emergencyStop", SafetyMode.ROBOT_EMERGENCY_STOP, StopCategory.ONE),
    SYSTEM_EMERGENCY("emergencyStop", SafetyMode.SYSTEM_EMERGENCY_STOP, StopCategory.ONE),
    SAFEGUARD("safeguardStop", SafetyMode.SAFEGUARD_STOP, StopCategory.TWO),
    AUTOMATIC_SAFEGUARD(
        "safeguardStop", SafetyMode.AUTOMATIC_MODE_SAFEGUARD_STOP, StopCategory.TWO),
    VIOLATION("violation", SafetyMode.VIOLATION, StopCategory.ZERO),
    FAULT("fault", SafetyMode.FAULT, StopCategory.ZERO),
    /** Stops nothing; mode and category are not used. */
    WARNING("warning", SafetyMode.NORMAL, StopCategory.TWO);

    /** Key of what the log says of it. */
    final String messageKey;

    final SafetyMode mode;
    final StopCategory category;

    Kind(String messageKey, SafetyMode mode, StopCategory category) {
      this.messageKey = messageKey;
      this.mode = mode;
      this.category = category;
    }
  }

  /** Stands for an argument that differs from case to case. */
  private static final int VARIES = -1;

  private final int code;
  private final int argument;
  private final Kind kind;

  /** Key of what has happened; empty where the others tell. */
  private final String sentenceKey;

  private final String unit;

  StopReason(int code, Kind kind, String sentenceKey, String unit) {
    this(code, VARIES, kind, sentenceKey, unit);
  }

  StopReason(int code, int argument, Kind kind, String sentenceKey, String unit) {
    this.code = code;
    this.argument = argument;
    this.kind = kind;
    this.sentenceKey = sentenceKey;
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
    String sentence = text(sentenceKey, text(JOINTS.get(joint)), joint);
    return stop(sentence, joint, OptionalInt.of(joint), timeS, value, limit);
  }

  /** A stop because of something that was measured. */
  SafetyStop of(double timeS, double value, double limit) {
    return stop(text(sentenceKey), 0, OptionalInt.empty(), timeS, value, limit);
  }

  /**
   * A stop because of a plane.
   *
   * @param part key of what is there: {@code tool} or {@code elbow}
   * @param number of the plane in the configuration, from 0
   */
  SafetyStop ofPlane(
      String part, SafetyPlane plane, int number, double timeS, double value, double limit) {
    String sentence = text(sentenceKey, text(part), plane.name());
    return stop(sentence, number, OptionalInt.empty(), timeS, value, limit);
  }

  /**
   * A stop because of the TCP and an axis of force mode's task frame.
   *
   * @param joint the argument, and the joint that it is about, 0 to 5
   */
  SafetyStop alongAxis(char axis, int joint, double timeS, double value, double limit) {
    String sentence = text(sentenceKey, axis);
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

  /** A stop because of an input. */
  SafetyStop ofInput(SafetyInput input, double timeS) {
    String sentence = text(sentenceKey, input.word());
    return stop(sentence, kind.mode.code(), OptionalInt.empty(), timeS, 0, 0);
  }

  /** A stop on request. */
  SafetyStop asked(double timeS) {
    return stop(text(sentenceKey), kind.mode.code(), OptionalInt.empty(), timeS, 0, 0);
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
    int digits = DIGITS;
    while (digits < MAX_DIGITS && number(value, digits).equals(number(limit, digits))) {
      digits++;
    }
    String told =
        measuredIn.isEmpty()
            ? sentence
            : text("measured", sentence, number(value, digits), measuredIn, number(limit, digits));
    String message = text(kind.messageKey, code, chosen, milliseconds(timeS), told);
    return new SafetyStop(
        kind.mode, kind.category, code, chosen, joint, timeS, value, limit, measuredIn, message);
  }

  private static BigDecimal milliseconds(double timeS) {
    return BigDecimal.valueOf(Math.round(timeS * 1000), 3);
  }

  private static String number(double value, int digits) {
    if (!Double.isFinite(value)) {
      return Double.toString(value);
    }
    BigDecimal rounded = new BigDecimal(value).round(new MathContext(digits));
    return rounded
        .setScale(Math.min(rounded.scale(), digits + LEADING_ZEROS), RoundingMode.HALF_EVEN)
        .stripTrailingZeros()
        .toPlainString();
  }
}
