package org.pendant.controller.safety;

import java.util.List;
import org.pendant.language.check.Nearest;
import org.pendant.models.arm.Joints;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** Limits reader: reads one set of limits over the standard one. */
final class LimitsReader {
  private LimitsReader() {}

  static SafetyLimits read(JsonFields fields, SafetyLimits standard) throws JsonException {
    fields.allow(
        Nearest::among,
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
          fields.number("powerW", LimitRanges.POWER, standard.powerW()),
          fields.number("momentumKgMPerS", LimitRanges.MOMENTUM, standard.momentumKgMPerS()),
          fields.number("stoppingTimeS", LimitRanges.STOPPING_TIME, standard.stoppingTimeS()),
          fields.number(
              "stoppingDistanceM", LimitRanges.STOPPING_DISTANCE, standard.stoppingDistanceM()),
          fields.number("toolSpeedMPerS", LimitRanges.SPEED, standard.toolSpeedMPerS()),
          fields.number("toolForceN", LimitRanges.FORCE, standard.toolForceN()),
          fields.number("elbowSpeedMPerS", LimitRanges.SPEED, standard.elbowSpeedMPerS()),
          fields.number("elbowForceN", LimitRanges.FORCE, standard.elbowForceN()),
          joints(
              fields, "jointSpeedRadPerS", LimitRanges.JOINT_SPEED, standard.jointSpeedRadPerS()),
          joints(fields, "jointMinRad", LimitRanges.JOINT_POSITION, standard.jointMinRad()),
          joints(fields, "jointMaxRad", LimitRanges.JOINT_POSITION, standard.jointMaxRad()));
    } catch (IllegalArgumentException e) {
      throw fields.place().refusal(e.getMessage());
    }
  }

  /** Six numbers, base first; {@code null} stands for the standard one. */
  private static Joints joints(JsonFields fields, String key, Range range, Joints standard)
      throws JsonException {
    if (fields.optional(key).isEmpty()) {
      return standard;
    }
    List<Json> values = fields.numbers(key, Joints.COUNT);
    double[] six = standard.toArray();
    for (int i = 0; i < six.length; i++) {
      boolean left = values.get(i) instanceof Json.Word word && word.word().equals("null");
      if (!left) {
        six[i] = JsonFields.number(key + "[" + i + "]", values.get(i), range);
      }
    }
    return Joints.of(six);
  }
}
