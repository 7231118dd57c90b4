package org.pendant.project.installation.text;

import static org.pendant.project.installation.text.InstallationLineTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.safety.ToolDirection;
import org.pendant.models.arm.Joints;
import org.pendant.project.program.text.WrongText;

/** Safety lines, below {@code safety}: a limit each, then planes and the tool direction. */
final class SafetyLines {
  static final String HEADING = "safety";

  private static final String NORMAL = "normal";
  private static final String REDUCED = "reduced";
  private static final List<String> NUMBERS =
      List.of(
          "power-w",
          "momentum-kg-m-per-s",
          "stopping-time-s",
          "stopping-distance-m",
          "tool-speed-m-per-s",
          "tool-force-n",
          "elbow-speed-m-per-s",
          "elbow-force-n");
  private static final String JOINT_SPEED = "joint-speed-rad-per-s";
  private static final String JOINT_MIN = "joint-min-rad";
  private static final String JOINT_MAX = "joint-max-rad";

  private final Map<String, double[]> normal = new HashMap<>();
  private final Map<String, double[]> reduced = new HashMap<>();
  private final List<SafetyPlane> planes = new ArrayList<>();
  private Optional<ToolDirection> direction = Optional.empty();

  static void write(SafetyConfiguration safety, StringBuilder out) {
    out.append(HEADING).append('\n');
    write(NORMAL, safety.normal(), out);
    write(REDUCED, safety.reduced(), out);
    for (SafetyPlane each : safety.planes()) {
      LineWriter.begin(out, "  plane")
          .text("name", each.name())
          .put("point-m", Words.of(each.pointXM(), each.pointYM(), each.pointZM()))
          .put("allowed-side", direction(each.allowedSide()))
          .put("applies", each.applies())
          .flag("elbow", each.elbow())
          .end();
    }
    if (safety.toolDirection().isPresent()) {
      ToolDirection tool = safety.toolDirection().get();
      LineWriter.begin(out, "  tool-direction")
          .put("allowed-in-base", direction(tool.allowedInBase()))
          .put("tool-in-flange", direction(tool.toolInFlange()))
          .put("largest-angle-rad", tool.largestAngleRad())
          .put("applies", tool.applies())
          .end();
    }
  }

  private static String direction(Axis axis) {
    return Words.of(axis.x(), axis.y(), axis.z());
  }

  private static void write(String set, SafetyLimits limits, StringBuilder out) {
    double[] numbers = {
      limits.powerW(),
      limits.momentumKgMPerS(),
      limits.stoppingTimeS(),
      limits.stoppingDistanceM(),
      limits.toolSpeedMPerS(),
      limits.toolForceN(),
      limits.elbowSpeedMPerS(),
      limits.elbowForceN()
    };
    for (int i = 0; i < numbers.length; i++) {
      limit(set, NUMBERS.get(i), Words.of(numbers[i]), out);
    }
    limit(set, JOINT_SPEED, Words.of(limits.jointSpeedRadPerS().toArray()), out);
    limit(set, JOINT_MIN, Words.of(limits.jointMinRad().toArray()), out);
    limit(set, JOINT_MAX, Words.of(limits.jointMaxRad().toArray()), out);
  }

  private static void limit(String set, String key, String value, StringBuilder out) {
    LineWriter.begin(out, "  " + set).put(key, value).end();
  }

  /**
   * Reads one of the lines.
   *
   * @throws IllegalArgumentException for values that a limit, a plane or a direction refuses
   */
  void read(String word, LineFields fields) throws WrongText {
    switch (word) {
      case NORMAL -> limits(fields, normal);
      case REDUCED -> limits(fields, reduced);
      case "plane" -> planes.add(plane(fields));
      case "tool-direction" -> {
        if (direction.isPresent()) {
          throw fields.wrong(text("directionTwice"));
        }
        direction = Optional.of(toolDirection(fields));
      }
      default -> throw fields.wrong(text("belowSafety"));
    }
  }

  private static void limits(LineFields fields, Map<String, double[]> into) throws WrongText {
    boolean any = false;
    for (String key : NUMBERS) {
      if (fields.has(key)) {
        put(fields, into, key, new double[] {fields.limit(key)});
        any = true;
      }
    }
    for (String key : List.of(JOINT_SPEED, JOINT_MIN, JOINT_MAX)) {
      if (fields.has(key)) {
        put(fields, into, key, fields.limits(key, Joints.COUNT));
        any = true;
      }
    }
    if (!any) {
      fields.requireAllKnown();
      throw fields.wrong(text("limitMissing"));
    }
  }

  private static void put(LineFields fields, Map<String, double[]> into, String key, double[] value)
      throws WrongText {
    if (into.putIfAbsent(key, value) != null) {
      throw fields.wrong(text("limitTwice", key));
    }
  }

  private static SafetyPlane plane(LineFields fields) throws WrongText {
    double[] point = fields.numbers("point-m", 3);
    return new SafetyPlane(
        fields.text("name"),
        point[0],
        point[1],
        point[2],
        axis(fields, "allowed-side"),
        fields.constant("applies", Applies.class, Applies.BOTH),
        fields.flag("elbow"));
  }

  private static ToolDirection toolDirection(LineFields fields) throws WrongText {
    return new ToolDirection(
        axis(fields, "allowed-in-base"),
        axis(fields, "tool-in-flange"),
        fields.number("largest-angle-rad"),
        fields.constant("applies", Applies.class, Applies.BOTH));
  }

  private static Axis axis(LineFields fields, String key) throws WrongText {
    double[] three = fields.numbers(key, 3);
    return new Axis(three[0], three[1], three[2]);
  }

  /**
   * What the lines say together.
   *
   * @throws IllegalArgumentException if a limit is missing, or they do not go together
   */
  SafetyConfiguration configuration() {
    return new SafetyConfiguration(
        limits(NORMAL, normal), limits(REDUCED, reduced), planes, direction);
  }

  private static SafetyLimits limits(String set, Map<String, double[]> given) {
    double[] numbers = new double[NUMBERS.size()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = value(set, given, NUMBERS.get(i))[0];
    }
    return new SafetyLimits(
        numbers[0],
        numbers[1],
        numbers[2],
        numbers[3],
        numbers[4],
        numbers[5],
        numbers[6],
        numbers[7],
        Joints.of(value(set, given, JOINT_SPEED)),
        Joints.of(value(set, given, JOINT_MIN)),
        Joints.of(value(set, given, JOINT_MAX)));
  }

  private static double[] value(String set, Map<String, double[]> given, String key) {
    double[] found = given.get(key);
    if (found == null) {
      throw new IllegalArgumentException(
          "the line   " + set + " " + key + "=... is missing, every limit must be given");
    }
    return found;
  }
}
