package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.safety.ToolDirection;
import org.pendant.project.installation.urp.SafetySections.Section;

/** Safety border reader: takes planes and the direction of the tool out of safety settings. */
final class SafetyBorderReader {
  private static final String DISABLED = "DISABLED";
  private static final int MAX_NAME = 100;

  private static final Map<String, Applies> MODES =
      Map.of(
          "NORMAL", Applies.NORMAL,
          "REDUCED", Applies.REDUCED,
          "BOTH", Applies.BOTH,
          "TRIGGER", Applies.TRIGGERS_REDUCED);

  private final SafetySections sections;
  private final Set<String> names = new HashSet<>();

  SafetyBorderReader(SafetySections sections) {
    this.sections = sections;
  }

  /** Whether there is anything to read. */
  boolean any() {
    for (int i = 0; i < SafetyConfiguration.MAX_PLANES; i++) {
      if (sections.has(planeName(i))) {
        return true;
      }
    }
    return sections.has("SafetyLimits ToolOrientation");
  }

  private static String planeName(int number) {
    return "SafetyLimits BoundaryPlane" + number;
  }

  /** The planes that are not switched off. */
  List<SafetyPlane> planes() {
    List<SafetyPlane> planes = new ArrayList<>();
    for (int i = 0; i < SafetyConfiguration.MAX_PLANES; i++) {
      Section section = sections.section(planeName(i));
      if (off(section)) {
        section.seeAll();
      } else {
        plane(section, i).ifPresent(planes::add);
      }
    }
    return planes;
  }

  private static boolean off(Section section) {
    return !section.has("mode") || section.text("mode").equals(DISABLED);
  }

  /** A plane allows the points p with n.p + d >= 0, n its normal and d its distance. */
  private Optional<SafetyPlane> plane(Section section, int number) {
    // where the normal and the distance came from
    section.text("sourceFeatureId");
    section.text("displacement");
    String name = name(section, number);
    Optional<Applies> applies = mode(section);
    Optional<Axis> side = axis(section, "planeNormal");
    OptionalDouble distance = section.number("distanceToOrigin");
    if (applies.isEmpty() || side.isEmpty() || distance.isEmpty()) {
      section.remark("name", text("planeLeftOut", SafetySections.shown(name)));
      section.seeAll();
      return Optional.empty();
    }
    double[] normal = section.numbers("planeNormal", 3).orElseThrow();
    double length =
        Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    double awayM = -distance.getAsDouble() / length;
    if (section.text("flangeRestricted").equals("true")) {
      section.remark("flangeRestricted", text("flangeNotModelled"));
    }
    Axis n = side.get();
    return Optional.of(
        new SafetyPlane(
            name,
            // no minus zero, which looks odd in a file
            awayM * n.x() + 0.0,
            awayM * n.y() + 0.0,
            awayM * n.z() + 0.0,
            new Axis(n.x() + 0.0, n.y() + 0.0, n.z() + 0.0),
            applies.get(),
            section.text("elbowRestricted").equals("true")));
  }

  /** A name of its own, that people can read. */
  private String name(Section section, int number) {
    String given = section.text("name").replaceAll("\\p{Cntrl}", "").strip();
    String wanted =
        given.isEmpty()
            ? "Plane " + number
            : given.substring(0, Math.min(given.length(), MAX_NAME));
    String name = wanted;
    for (int i = 2; !names.add(name); i++) {
      name = wanted + " (" + i + ")";
    }
    if (!name.equals(section.text("name"))) {
      section.remark(
          "name",
          text(
              "planeRenamed",
              SafetySections.shown(section.text("name")),
              SafetySections.shown(name)));
    }
    return name;
  }

  private static Optional<Applies> mode(Section section) {
    Optional<Applies> mode = Optional.ofNullable(MODES.get(section.text("mode")));
    if (mode.isEmpty()) {
      section.broken("mode", text("modeUnknown"));
    }
    return mode;
  }

  private static Optional<Axis> axis(Section section, String key) {
    Optional<double[]> numbers = section.numbers(key, 3);
    if (numbers.isEmpty()) {
      return Optional.empty();
    }
    double[] n = numbers.get();
    try {
      return Optional.of(new Axis(n[0], n[1], n[2]));
    } catch (IllegalArgumentException e) {
      section.broken(key, text("noDirection"));
      return Optional.empty();
    }
  }

  /** How far the tool may be tilted. */
  Optional<ToolDirection> toolDirection() {
    Section section = sections.section("SafetyLimits ToolOrientation");
    if (off(section)) {
      section.seeAll();
      return Optional.empty();
    }
    Optional<Applies> applies = mode(section);
    Optional<Axis> allowed = axis(section, "tcpOrientationVector");
    OptionalDouble largest = section.number("maximumTcpOrientationDeviation");
    if (applies.isPresent() && allowed.isPresent() && largest.isPresent()) {
      if (largest.getAsDouble() >= Math.PI) {
        // half a turn and more: any direction is allowed
        return Optional.empty();
      }
      try {
        return Optional.of(
            new ToolDirection(allowed.get(), toolAxis(), largest.getAsDouble(), applies.get()));
      } catch (IllegalArgumentException e) {
        section.remark("mode", text("directionUnobeyed", e.getMessage()));
      }
    }
    section.remark("mode", text("directionLeftOut"));
    return Optional.empty();
  }

  /** The tool's own direction along the axes of the flange, given as polar angles. */
  private Axis toolAxis() {
    Section tool = sections.section(UnmodelledSafety.WORKPIECE);
    double inclination = tool.number("toolDirectionInclination").orElse(0);
    double azimuth = tool.number("toolDirectionAzimuth").orElse(0);
    return new Axis(
        Math.sin(inclination) * Math.cos(azimuth),
        Math.sin(inclination) * Math.sin(azimuth),
        Math.cos(inclination));
  }
}
