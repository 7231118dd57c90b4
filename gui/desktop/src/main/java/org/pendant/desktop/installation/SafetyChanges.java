package org.pendant.desktop.installation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;
import org.pendant.models.arm.Joints;

/** Safety changes: what differs between two safety configurations, in words. */
final class SafetyChanges {
  private SafetyChanges() {}

  /** A line for each difference. */
  static List<String> of(SafetyConfiguration before, SafetyConfiguration after, Measures measures) {
    List<String> lines = new ArrayList<>();
    limits("Normal", before.normal(), after.normal(), measures, lines);
    limits("Reduced", before.reduced(), after.reduced(), measures, lines);
    planes(before.planes(), after.planes(), lines);
    if (!before.toolDirection().equals(after.toolDirection())) {
      lines.add(
          after.toolDirection().isEmpty()
              ? "Tool direction: no longer restricted"
              : before.toolDirection().isEmpty()
                  ? "Tool direction: restricted"
                  : "Tool direction: changed");
    }
    return lines;
  }

  private static void limits(
      String set, SafetyLimits before, SafetyLimits after, Measures measures, List<String> lines) {
    for (LimitKind kind : LimitKind.values()) {
      if (kind.of(before) != kind.of(after)) {
        lines.add(
            set
                + " "
                + kind.title().toLowerCase(Locale.ROOT)
                + ": "
                + measures.of(kind.unit()).text(kind.of(before))
                + " to "
                + measures.of(kind.unit()).words(kind.of(after)));
      }
    }
    Measure speed = measures.of(Measure.DEGREE_PER_S);
    Measure angle = measures.of(Measure.DEGREE);
    for (int i = 0; i < Joints.COUNT; i++) {
      String joint = set + " " + JointLimitsPage.NAMES.get(i).toLowerCase(Locale.ROOT);
      if (before.jointSpeedRadPerS().get(i) != after.jointSpeedRadPerS().get(i)) {
        lines.add(
            joint
                + " speed: "
                + speed.text(before.jointSpeedRadPerS().get(i))
                + " to "
                + speed.words(after.jointSpeedRadPerS().get(i)));
      }
      if (before.jointMinRad().get(i) != after.jointMinRad().get(i)
          || before.jointMaxRad().get(i) != after.jointMaxRad().get(i)) {
        lines.add(joint + " range: " + range(before, i, angle) + " to " + range(after, i, angle));
      }
    }
  }

  private static String range(SafetyLimits limits, int joint, Measure angle) {
    return "["
        + JointLimitsPage.words(limits.jointMinRad().get(joint), angle)
        + ", "
        + JointLimitsPage.words(limits.jointMaxRad().get(joint), angle)
        + "] "
        + angle.symbol();
  }

  private static void planes(
      List<SafetyPlane> before, List<SafetyPlane> after, List<String> lines) {
    for (SafetyPlane each : after) {
      Optional<SafetyPlane> was = named(before, each.name());
      if (was.isEmpty()) {
        lines.add("Plane " + each.name() + ": new");
      } else if (!was.get().equals(each)) {
        lines.add("Plane " + each.name() + ": changed");
      }
    }
    for (SafetyPlane each : before) {
      if (named(after, each.name()).isEmpty()) {
        lines.add("Plane " + each.name() + ": removed");
      }
    }
    if (lines.isEmpty() && !before.equals(after)) {
      lines.add("Planes: another order");
    }
  }

  private static Optional<SafetyPlane> named(List<SafetyPlane> planes, String name) {
    return planes.stream().filter(each -> each.name().equals(name)).findFirst();
  }
}
