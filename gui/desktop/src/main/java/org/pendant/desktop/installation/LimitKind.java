package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.EnumMap;
import java.util.Map;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.kit.form.Measure;
import org.pendant.models.arm.Joints;

/** Limit kinds: the limits of the robot as a whole. */
enum LimitKind {
  POWER(text("power"), Measure.WATT),
  MOMENTUM(text("momentum"), Measure.KILOGRAM_METRE_PER_S),
  STOPPING_TIME(text("stoppingTime"), Measure.SECOND),
  STOPPING_DISTANCE(text("stoppingDistance"), Measure.MILLIMETRE),
  TOOL_SPEED(text("toolSpeed"), Measure.MILLIMETRE_PER_S),
  TOOL_FORCE(text("toolForce"), Measure.NEWTON),
  ELBOW_SPEED(text("elbowSpeed"), Measure.MILLIMETRE_PER_S),
  ELBOW_FORCE(text("elbowForce"), Measure.NEWTON);

  private final String title;
  private final Measure unit;

  LimitKind(String title, Measure unit) {
    this.title = title;
    this.unit = unit;
  }

  String title() {
    return title;
  }

  Measure unit() {
    return unit;
  }

  double of(SafetyLimits limits) {
    return switch (this) {
      case POWER -> limits.powerW();
      case MOMENTUM -> limits.momentumKgMPerS();
      case STOPPING_TIME -> limits.stoppingTimeS();
      case STOPPING_DISTANCE -> limits.stoppingDistanceM();
      case TOOL_SPEED -> limits.toolSpeedMPerS();
      case TOOL_FORCE -> limits.toolForceN();
      case ELBOW_SPEED -> limits.elbowSpeedMPerS();
      case ELBOW_FORCE -> limits.elbowForceN();
    };
  }

  /** Limits with another value for this one. */
  SafetyLimits with(SafetyLimits limits, double value) {
    Map<LimitKind, Double> values = values(limits);
    values.put(this, value);
    return limits(values, limits.jointSpeedRadPerS(), limits.jointMinRad(), limits.jointMaxRad());
  }

  /** All of these limits. */
  static Map<LimitKind, Double> values(SafetyLimits limits) {
    Map<LimitKind, Double> values = new EnumMap<>(LimitKind.class);
    for (LimitKind each : values()) {
      values.put(each, each.of(limits));
    }
    return values;
  }

  /** Limits of these and of the joints. */
  static SafetyLimits limits(Map<LimitKind, Double> v, Joints speed, Joints min, Joints max) {
    return new SafetyLimits(
        v.get(POWER),
        v.get(MOMENTUM),
        v.get(STOPPING_TIME),
        v.get(STOPPING_DISTANCE),
        v.get(TOOL_SPEED),
        v.get(TOOL_FORCE),
        v.get(ELBOW_SPEED),
        v.get(ELBOW_FORCE),
        speed,
        min,
        max);
  }

  /** Each limit at most as wide as in another set. */
  static SafetyLimits within(SafetyLimits limits, SafetyLimits wider) {
    Map<LimitKind, Double> v = values(limits);
    v.replaceAll((kind, value) -> Math.min(value, kind.of(wider)));
    double[] speed = limits.jointSpeedRadPerS().toArray();
    double[] min = limits.jointMinRad().toArray();
    double[] max = limits.jointMaxRad().toArray();
    for (int i = 0; i < Joints.COUNT; i++) {
      speed[i] = Math.min(speed[i], wider.jointSpeedRadPerS().get(i));
      min[i] = Math.max(min[i], wider.jointMinRad().get(i));
      max[i] = Math.min(max[i], wider.jointMaxRad().get(i));
      if (min[i] >= max[i]) {
        min[i] = wider.jointMinRad().get(i);
        max[i] = wider.jointMaxRad().get(i);
      }
    }
    return limits(v, Joints.of(speed), Joints.of(min), Joints.of(max));
  }
}
