package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.safety.LimitRanges;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.json.Range;
import org.pendant.project.installation.urp.SafetySections.Section;
import org.pendant.project.polyscope.xml.XmlElement;

/**
 * Safety settings reader: takes limits, planes and tool direction out of the text of safety
 * settings. What is missing or broken in it is left to the arm, for which infinity stands in the
 * limits.
 */
final class SafetySettingsReader {
  /** Revolutions from here on stand for no limit: robots write the largest whole number. */
  private static final double ENDLESS_REVOLUTIONS = 1e6;

  /** What files differ by between two writings of one angle, rad. */
  private static final double ROUNDING_RAD = 1e-6;

  private static final String JOINT_SPEED = "maxJointSpeed";

  /** A limit of the whole arm, as files call it. */
  private record Quantity(String key, Range range, ToDoubleFunction<SafetyLimits> of) {}

  /** In the order of {@link SafetyLimits}. */
  private static final List<Quantity> QUANTITIES =
      List.of(
          new Quantity("maxPower", LimitRanges.POWER, SafetyLimits::powerW),
          new Quantity("maxMomentum", LimitRanges.MOMENTUM, SafetyLimits::momentumKgMPerS),
          new Quantity("maxStoppingTime", LimitRanges.STOPPING_TIME, SafetyLimits::stoppingTimeS),
          new Quantity(
              "maxStoppingDistance",
              LimitRanges.STOPPING_DISTANCE,
              SafetyLimits::stoppingDistanceM),
          new Quantity("maxTcpSpeed", LimitRanges.SPEED, SafetyLimits::toolSpeedMPerS),
          new Quantity("maxForce", LimitRanges.FORCE, SafetyLimits::toolForceN),
          new Quantity("maxElbowSpeed", LimitRanges.SPEED, SafetyLimits::elbowSpeedMPerS),
          new Quantity("maxElbowForce", LimitRanges.FORCE, SafetyLimits::elbowForceN));

  private final SafetyRemarks remarks;
  private final SafetySections sections;

  /** What the normal limits lack. */
  private final Set<String> lacking = new HashSet<>();

  /** For each joint whether its range is limited at all; fewer for all of them. */
  private final List<String> limited;

  private SafetySettingsReader(XmlElement element, SafetyRemarks remarks) {
    this.remarks = remarks;
    sections = new SafetySections(element.text(), element.line(), remarks);
    limited = SafetySections.items(sections.section("SafetySetup").text("withPositionLimits"));
  }

  /** The configuration; empty if the element holds no limits and no planes. */
  static Optional<SafetyConfiguration> read(XmlElement element, List<String> all) {
    SafetyRemarks remarks = new SafetyRemarks(all);
    Optional<SafetyConfiguration> read = new SafetySettingsReader(element, remarks).read();
    if (read.isEmpty()) {
      remarks.add(element.line(), text("noLimits"));
    }
    remarks.close();
    return read;
  }

  private Optional<SafetyConfiguration> read() {
    SafetyBorderReader borders = new SafetyBorderReader(sections);
    boolean any = borders.any();
    for (String set : List.of("Normal", "Reduced")) {
      any |= sections.has(name(set, "Values")) || sections.has(name(set, "Joints"));
    }
    Optional<SafetyConfiguration> read = Optional.empty();
    if (any) {
      SafetyLimits normal = limits("Normal", Optional.empty());
      SafetyLimits reduced = limits("Reduced", Optional.of(normal));
      read =
          Optional.of(
              new SafetyConfiguration(normal, reduced, borders.planes(), borders.toolDirection()));
    }
    new UnmodelledSafety(sections).tell();
    sections.tellUnread();
    return read;
  }

  private static String name(String set, String part) {
    return "SafetyLimits " + set + " " + part;
  }

  /**
   * One set of limits.
   *
   * @param normal for the reduced set: what it must be within
   */
  private SafetyLimits limits(String set, Optional<SafetyLimits> normal) {
    Section values = sections.section(name(set, "Values"));
    Section joints = sections.section(name(set, "Joints"));
    List<String> missing = new ArrayList<>();
    double[] v = new double[QUANTITIES.size()];
    for (int i = 0; i < v.length; i++) {
      Quantity each = QUANTITIES.get(i);
      double widest =
          normal.isPresent() ? each.of().applyAsDouble(normal.get()) : Double.POSITIVE_INFINITY;
      v[i] = value(values, each, widest, missing);
    }
    Joints speed = speed(joints, normal.map(SafetyLimits::jointSpeedRadPerS), missing);
    double[] min = ends(joints, "min", Double.NEGATIVE_INFINITY, missing);
    double[] max = ends(joints, "max", Double.POSITIVE_INFINITY, missing);
    for (int i = 0; i < Joints.COUNT; i++) {
      fitRange(joints, i, min, max, normal);
    }
    missing.removeAll(lacking);
    lacking.addAll(missing);
    if (!missing.isEmpty()) {
      remarks.add(
          0, text(normal.isPresent() ? "reducedLacks" : "normalLacks", String.join(", ", missing)));
    }
    return new SafetyLimits(
        v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], speed, Joints.of(min), Joints.of(max));
  }

  private static double value(
      Section section, Quantity quantity, double widest, List<String> missing) {
    OptionalDouble number = section.number(quantity.key());
    if (number.isEmpty()) {
      missing.add(quantity.key());
      return widest;
    }
    return limited(
        section,
        quantity.key(),
        OptionalInt.empty(),
        number.getAsDouble(),
        quantity.range(),
        widest);
  }

  private static Joints speed(Section joints, Optional<Joints> normal, List<String> missing) {
    double[] widest = normal.map(Joints::toArray).orElse(all(Double.POSITIVE_INFINITY));
    Optional<double[]> read = joints.numbers(JOINT_SPEED, Joints.COUNT);
    if (read.isEmpty()) {
      missing.add(JOINT_SPEED);
      return Joints.of(widest);
    }
    double[] speed = read.get();
    for (int i = 0; i < speed.length; i++) {
      OptionalInt joint = OptionalInt.of(i);
      speed[i] = limited(joints, JOINT_SPEED, joint, speed[i], LimitRanges.JOINT_SPEED, widest[i]);
    }
    return Joints.of(speed);
  }

  /** A limit that a model can have, and that is not wider than the normal one. */
  private static double limited(
      Section section, String key, OptionalInt joint, double wanted, Range range, double widest) {
    double held = Math.clamp(wanted, range.least(), range.most());
    if (held != wanted) {
      section.remark(
          key,
          outOfRange(
              joint,
              with(wanted, range),
              Range.number(range.least()),
              with(range.most(), range),
              with(held, range)));
    }
    if (held > widest) {
      section.remark(
          key,
          joint.isPresent()
              ? text("jointBeyondNormal", joint.getAsInt(), with(held, range), with(widest, range))
              : text("beyondNormal", with(held, range), with(widest, range)));
    }
    return Math.min(held, widest);
  }

  private static String outOfRange(
      OptionalInt joint, String wanted, String least, String most, String held) {
    return joint.isPresent()
        ? text("jointOutOfRange", joint.getAsInt(), wanted, least, most, held)
        : text("outOfRange", wanted, least, most, held);
  }

  private static String with(double value, Range range) {
    return Range.number(value) + " " + range.unit();
  }

  /**
   * One end of the ranges of all joints: an angle within a revolution, and how many revolutions
   * that is away from 0.
   *
   * @param free what stands for no limit, rad
   */
  private double[] ends(Section joints, String end, double free, List<String> missing) {
    Optional<double[]> angles = joints.numbers(end + "JointPosition", Joints.COUNT);
    Optional<double[]> revolutions = joints.numbers(end + "JointRevolutions", Joints.COUNT);
    double[] ends = all(free);
    if (angles.isEmpty() || revolutions.isEmpty()) {
      missing.add(end + "JointPosition with " + end + "JointRevolutions");
      return ends;
    }
    for (int i = 0; i < ends.length; i++) {
      boolean off = limited.size() == Joints.COUNT && limited.get(i).equals("false");
      double turns = revolutions.get()[i];
      if (!off && Math.abs(turns) < ENDLESS_REVOLUTIONS) {
        ends[i] = angles.get()[i] + 2 * Math.PI * turns;
      }
    }
    return ends;
  }

  /** Makes the range of a joint one that there can be, within the normal one. */
  private static void fitRange(
      Section joints, int i, double[] min, double[] max, Optional<SafetyLimits> normal) {
    double least = normal.map(each -> each.jointMinRad().get(i)).orElse(Double.NEGATIVE_INFINITY);
    double most = normal.map(each -> each.jointMaxRad().get(i)).orElse(Double.POSITIVE_INFINITY);
    double from = Math.max(min[i], least);
    double to = Math.min(max[i], most);
    boolean empty = !(from < to);
    boolean wider =
        (Double.isFinite(min[i]) && min[i] < least - ROUNDING_RAD)
            || (Double.isFinite(max[i]) && max[i] > most + ROUNDING_RAD);
    if (empty || wider) {
      double heldFrom = empty ? least : from;
      double heldTo = empty ? most : to;
      joints.remark(
          "minJointPosition",
          Double.isInfinite(heldFrom) && Double.isInfinite(heldTo)
              ? text(normal.isPresent() ? "reducedRangeOfArm" : "rangeOfArm", i, min[i], max[i])
              : text(
                  normal.isPresent() ? "reducedRangeHeld" : "rangeHeld",
                  i,
                  min[i],
                  max[i],
                  heldFrom,
                  heldTo));
    }
    min[i] = empty ? least : from;
    max[i] = empty ? most : to;
  }

  private static double[] all(double value) {
    double[] values = new double[Joints.COUNT];
    Arrays.fill(values, value);
    return values;
  }
}
