package org.pendant.controller.safety;

import java.util.List;
import org.pendant.controller.json.Fields;
import org.pendant.controller.json.Json;
import org.pendant.controller.json.JsonException;
import org.pendant.controller.json.Range;
import org.pendant.models.arm.Joints;

/** Reads one set of limits over the standard one. */
final class LimitsReader {
  private static final Range POWER = new Range(1, 10_000, "W");
  private static final Range MOMENTUM = new Range(0.1, 1000, "kg m/s");
  private static final Range STOPPING_TIME = new Range(0.01, 10, "s");
  private static final Range STOPPING_DISTANCE = new Range(0.01, 10, "m");
  private static final Range SPEED = new Range(0.01, 20, "m/s");
  private static final Range FORCE = new Range(1, 10_000, "N");
  private static final Range JOINT_SPEED = new Range(0.01, 20, "rad/s");
  private static final Range JOINT_POSITION = new Range(-1000, 1000, "rad");

  private LimitsReader() {}

  static SafetyLimits read(Fields fields, SafetyLimits standard) throws JsonException {
    fields.allow(
        "powerW",
        "momentumKgMPerS",
        "stoppingTimeS",
        "stoppingDistanceM",
        "toolSpeedMPerS",
        "toolForceN",
        "elbowSpeedMPerS",
        "elbowForceN",
        "jointSpeedRadPerS",
        "jointMinRad",
        "jointMaxRad");
    try {
      return new SafetyLimits(
          fields.number("powerW", POWER, standard.powerW()),
          fields.number("momentumKgMPerS", MOMENTUM, standard.momentumKgMPerS()),
          fields.number("stoppingTimeS", STOPPING_TIME, standard.stoppingTimeS()),
          fields.number("stoppingDistanceM", STOPPING_DISTANCE, standard.stoppingDistanceM()),
          fields.number("toolSpeedMPerS", SPEED, standard.toolSpeedMPerS()),
          fields.number("toolForceN", FORCE, standard.toolForceN()),
          fields.number("elbowSpeedMPerS", SPEED, standard.elbowSpeedMPerS()),
          fields.number("elbowForceN", FORCE, standard.elbowForceN()),
          joints(fields, "jointSpeedRadPerS", JOINT_SPEED, standard.jointSpeedRadPerS()),
          joints(fields, "jointMinRad", JOINT_POSITION, standard.jointMinRad()),
          joints(fields, "jointMaxRad", JOINT_POSITION, standard.jointMaxRad()));
    } catch (IllegalArgumentException e) {
      throw fields.place().refusal(e.getMessage());
    }
  }

  /** Six numbers, base first; {@code null} stands for the standard one. */
  private static Joints joints(Fields fields, String key, Range range, Joints standard)
      throws JsonException {
    if (fields.optional(key).isEmpty()) {
      return standard;
    }
    List<Json> values = fields.numbers(key, Joints.COUNT);
    double[] six = standard.toArray();
    for (int i = 0; i < six.length; i++) {
      boolean left = values.get(i) instanceof Json.Word word && word.word().equals("null");
      if (!left) {
        six[i] = Fields.number(key + "[" + i + "]", values.get(i), range);
      }
    }
    return Joints.of(six);
  }
}
