package org.pendant.models.arm;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.json.JsonObject;

/**
 * Reads an arm description from JSON. Every start of the program comes through here: no code made
 * at run time (lambdas, text joined by plus) where nothing is wrong.
 *
 * <p>The layout is the records' own: the same names with their units, links' centre of mass and
 * inertia as arrays {@code [x, y, z]} and {@code [xx, xy, xz, yy, yz, zz]}.
 */
final class DescriptionReader {
  private DescriptionReader() {}

  /** Reads a whole file; an {@link IllegalStateException} says what is wrong with it. */
  static ArmDescription read(JsonObject root) {
    try {
      return description(root);
    } catch (IllegalArgumentException e) {
      throw root.refused(e);
    }
  }

  private static ArmDescription description(JsonObject root) {
    List<JointLimits> joints = new ArrayList<>();
    List<Actuator> actuators = new ArrayList<>();
    for (JsonObject joint : root.objects("joints")) {
      joints.add(limits(joint));
      actuators.add(actuator(joint));
    }
    List<LinkMass> links = new ArrayList<>();
    for (JsonObject link : root.objects("links")) {
      links.add(link(link));
    }
    return new ArmDescription(
        root.text("id"),
        root.text("displayName"),
        series(root.text("series")),
        lengths(root.object("dh")),
        joints,
        actuators,
        links,
        root.number("payloadKg"),
        root.number("reachM"),
        status(root.object("status")),
        root.texts("notes"));
  }

  private static Series series(String name) {
    for (Series each : Series.values()) {
      if (each.displayName().equals(name)) {
        return each;
      }
    }
    throw new IllegalArgumentException(
        "series is " + name + ", must be CB3, e-Series or UR-Series");
  }

  private static DhLengths lengths(JsonObject dh) {
    return new DhLengths(
        dh.number("d1"),
        dh.number("a2"),
        dh.number("a3"),
        dh.number("d4"),
        dh.number("d5"),
        dh.number("d6"));
  }

  private static ArmDescription.Status status(JsonObject status) {
    return new ArmDescription.Status(
        Confidence.named(status.text("kinematics")),
        Confidence.named(status.text("masses")),
        Confidence.named(status.text("inertias")),
        Confidence.named(status.text("jointLimits")),
        Confidence.named(status.text("actuators")));
  }

  private static JointLimits limits(JsonObject joint) {
    boolean unlimited = joint.flag("unlimited");
    return new JointLimits(
        unlimited ? Double.NEGATIVE_INFINITY : joint.number("minRad"),
        unlimited ? Double.POSITIVE_INFINITY : joint.number("maxRad"),
        joint.number("maxSpeedRadPerS"),
        joint.number("maxTorqueNm"));
  }

  private static Actuator actuator(JsonObject joint) {
    return new Actuator(
        joint.number("rotorInertiaKgM2"),
        joint.number("coulombNm"),
        joint.number("viscousNmSPerRad"),
        joint.number("torqueConstantNmPerA"));
  }

  private static LinkMass link(JsonObject link) {
    double[] com = link.numbers("comM", 3);
    double[] inertia = link.numbers("inertiaKgM2", 6);
    return new LinkMass(
        link.text("name"),
        link.number("massKg"),
        com[0],
        com[1],
        com[2],
        inertia[0],
        inertia[1],
        inertia[2],
        inertia[3],
        inertia[4],
        inertia[5]);
  }
}
