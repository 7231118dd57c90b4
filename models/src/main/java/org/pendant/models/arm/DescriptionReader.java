package org.pendant.models.arm;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;

/**
 * Arm description reader: reads one from JSON. Every start of the program comes through here: no
 * code made at run time (lambdas, text joined by plus) where nothing is wrong.
 *
 * <p>The layout is the records' own: the same names with their units, links' centre of mass and
 * inertia as arrays {@code [x, y, z]} and {@code [xx, xy, xz, yy, yz, zz]}.
 */
final class DescriptionReader {
  private DescriptionReader() {}

  /**
   * Reads a whole file.
   *
   * @throws JsonException if a member is missing or of the wrong type
   * @throws IllegalArgumentException if there is no such arm
   */
  static ArmDescription read(JsonFields root) throws JsonException {
    List<JointLimits> joints = new ArrayList<>();
    List<Actuator> actuators = new ArrayList<>();
    for (JsonFields joint : root.objects("joints")) {
      joints.add(limits(joint));
      actuators.add(actuator(joint));
    }
    List<LinkMass> links = new ArrayList<>();
    for (JsonFields link : root.objects("links")) {
      links.add(link(link));
    }
    return new ArmDescription(
        root.text("id").value(),
        root.text("displayName").value(),
        series(root.text("series").value()),
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

  private static DhLengths lengths(JsonFields dh) throws JsonException {
    return new DhLengths(
        dh.number("d1"),
        dh.number("a2"),
        dh.number("a3"),
        dh.number("d4"),
        dh.number("d5"),
        dh.number("d6"));
  }

  private static ArmDescription.Status status(JsonFields status) throws JsonException {
    return new ArmDescription.Status(
        Confidence.named(status.text("kinematics").value()),
        Confidence.named(status.text("masses").value()),
        Confidence.named(status.text("inertias").value()),
        Confidence.named(status.text("jointLimits").value()));
  }

  private static JointLimits limits(JsonFields joint) throws JsonException {
    boolean unlimited = joint.flag("unlimited");
    return new JointLimits(
        unlimited ? Double.NEGATIVE_INFINITY : joint.number("minRad"),
        unlimited ? Double.POSITIVE_INFINITY : joint.number("maxRad"),
        joint.number("maxSpeedRadPerS"),
        joint.number("maxTorqueNm"));
  }

  private static Actuator actuator(JsonFields joint) throws JsonException {
    return new Actuator(
        joint.number("rotorInertiaKgM2"),
        joint.number("torqueConstantNmPerA"),
        friction(joint.object("friction")),
        driveStatus(joint.object("status")));
  }

  private static FrictionCurve friction(JsonFields friction) throws JsonException {
    return new FrictionCurve(
        friction.number("coulombA"),
        friction.number("curvedA"),
        friction.number("curveSpeedRadPerS"),
        friction.number("viscousASPerRad"),
        friction.number("loadAPerNm"));
  }

  private static Actuator.Status driveStatus(JsonFields status) throws JsonException {
    return new Actuator.Status(
        Confidence.named(status.text("rotorInertia").value()),
        Confidence.named(status.text("torqueConstant").value()),
        Confidence.named(status.text("friction").value()));
  }

  private static LinkMass link(JsonFields link) throws JsonException {
    double[] com = link.vector("comM", 3);
    double[] inertia = link.vector("inertiaKgM2", 6);
    return new LinkMass(
        link.text("name").value(),
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
