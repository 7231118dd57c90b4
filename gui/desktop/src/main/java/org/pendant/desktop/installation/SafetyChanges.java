package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;
import org.pendant.models.arm.Joints;
import org.pendant.text.Language;

/** Safety changes: what differs between two safety configurations, in words. */
final class SafetyChanges {
  private SafetyChanges() {}

  /** A line for each difference. */
  static List<String> of(SafetyConfiguration before, SafetyConfiguration after, Measures measures) {
    List<String> lines = new ArrayList<>();
    limits(text("normal"), before.normal(), after.normal(), measures, lines);
    limits(text("reduced"), before.reduced(), after.reduced(), measures, lines);
    planes(before.planes(), after.planes(), lines);
    if (!before.toolDirection().equals(after.toolDirection())) {
      lines.add(
          after.toolDirection().isEmpty()
              ? text("toolDirectionNoLongerRestricted")
              : before.toolDirection().isEmpty()
                  ? text("toolDirectionRestricted")
                  : text("toolDirectionChanged"));
    }
    return lines;
  }

  private static void limits(
      String set, SafetyLimits before, SafetyLimits after, Measures measures, List<String> lines) {
    for (LimitKind kind : LimitKind.values()) {
      if (kind.of(before) != kind.of(after)) {
        lines.add(
            text(
                "limitChanged",
                set,
                Language.ofProcess().withinSentence(kind.title()),
                measures.of(kind.unit()).text(kind.of(before)),
                measures.of(kind.unit()).words(kind.of(after))));
      }
    }
    Measure speed = measures.of(Measure.DEGREE_PER_S);
    Measure angle = measures.of(Measure.DEGREE);
    for (int i = 0; i < Joints.COUNT; i++) {
      String joint = Language.ofProcess().withinSentence(JointLimitsPage.NAMES.get(i));
      if (before.jointSpeedRadPerS().get(i) != after.jointSpeedRadPerS().get(i)) {
        lines.add(
            text(
                "jointSpeedChanged",
                set,
                joint,
                speed.text(before.jointSpeedRadPerS().get(i)),
                speed.words(after.jointSpeedRadPerS().get(i))));
      }
      if (before.jointMinRad().get(i) != after.jointMinRad().get(i)
          || before.jointMaxRad().get(i) != after.jointMaxRad().get(i)) {
        lines.add(
            text("jointRangeChanged", set, joint, range(before, i, angle), range(after, i, angle)));
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
        lines.add(text("planeNew", each.name()));
      } else if (!was.get().equals(each)) {
        lines.add(text("planeChanged", each.name()));
      }
    }
    for (SafetyPlane each : before) {
      if (named(after, each.name()).isEmpty()) {
        lines.add(text("planeRemoved", each.name()));
      }
    }
    if (lines.isEmpty() && !before.equals(after)) {
      lines.add(text("planesAnotherOrder"));
    }
  }

  private static Optional<SafetyPlane> named(List<SafetyPlane> planes, String name) {
    return planes.stream().filter(each -> each.name().equals(name)).findFirst();
  }
}
