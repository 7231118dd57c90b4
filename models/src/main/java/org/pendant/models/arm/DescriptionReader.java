package org.pendant.models.arm;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/**
 * Arm description reader: reads one from JSON. Every start of the program comes through here: no
 * code made at run time (lambdas, text joined by plus) where nothing is wrong.
 *
 * <p>The layout is the records' own: the same names with their units, links' centre of mass and
 * inertia as arrays {@code [x, y, z]} and {@code [xx, xy, xz, yy, yz, zz]}.
 */
final class DescriptionReader {
  /** No number of an arm is larger: one that is would only upset what is computed with it. */
  private static final Range ANY = new Range(-1e4, 1e4, "");

  private DescriptionReader() {}

  /**
   * Reads a whole file.
   *
   * @throws JsonException if a member is missing, of the wrong type or a number that no arm has
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
    try {
      return new ArmDescription(
          root.text("id").value(),
          root.text("displayName").value(),
          series(root.text("series")),
          lengths(root.object("dh")),
          Calibration.NONE,
          joints,
          actuators,
          links,
          root.number("payloadKg", ANY),
          root.number("reachM", ANY),
          status(root.object("status")),
          root.texts("notes"));
    } catch (IllegalArgumentException e) {
      throw root.place().refusal(e.getMessage());
    }
  }

  private static Series series(Json.Text name) throws JsonException {
    for (Series each : Series.values()) {
      if (each.displayName().equals(name.value())) {
        return each;
      }
    }
    throw name.place().refusal(ArmTexts.text("wrongSeries", name.value()));
  }

  private static DhLengths lengths(JsonFields dh) throws JsonException {
    try {
      return new DhLengths(
          dh.number("d1", ANY),
          dh.number("a2", ANY),
          dh.number("a3", ANY),
          dh.number("d4", ANY),
          dh.number("d5", ANY),
          dh.number("d6", ANY));
    } catch (IllegalArgumentException e) {
      throw dh.place().refusal(e.getMessage());
    }
  }

  private static ArmDescription.Status status(JsonFields status) throws JsonException {
    return new ArmDescription.Status(
        confidence(status, "kinematics"),
        confidence(status, "masses"),
        confidence(status, "inertias"),
        confidence(status, "jointLimits"));
  }

  private static JointLimits limits(JsonFields joint) throws JsonException {
    boolean unlimited = joint.flag("unlimited");
    try {
      return new JointLimits(
          unlimited ? Double.NEGATIVE_INFINITY : joint.number("minRad", ANY),
          unlimited ? Double.POSITIVE_INFINITY : joint.number("maxRad", ANY),
          joint.number("maxSpeedRadPerS", ANY),
          joint.number("maxTorqueNm", ANY));
    } catch (IllegalArgumentException e) {
      throw joint.place().refusal(e.getMessage());
    }
  }

  private static Actuator actuator(JsonFields joint) throws JsonException {
    try {
      return new Actuator(
          joint.number("rotorInertiaKgM2", ANY),
          joint.number("torqueConstantNmPerA", ANY),
          friction(joint.object("friction")),
          joint.number("lagS", ANY, Actuator.USUAL_LAG_S),
          driveStatus(joint.object("status")));
    } catch (IllegalArgumentException e) {
      throw joint.place().refusal(e.getMessage());
    }
  }

  private static FrictionCurve friction(JsonFields friction) throws JsonException {
    try {
      return new FrictionCurve(
          friction.number("coulombA", ANY),
          friction.number("curvedA", ANY),
          friction.number("curveSpeedRadPerS", ANY),
          friction.number("viscousASPerRad", ANY),
          friction.number("loadAPerNm", ANY));
    } catch (IllegalArgumentException e) {
      throw friction.place().refusal(e.getMessage());
    }
  }

  private static Actuator.Status driveStatus(JsonFields status) throws JsonException {
    return new Actuator.Status(
        confidence(status, "rotorInertia"),
        confidence(status, "torqueConstant"),
        confidence(status, "friction"));
  }

  private static LinkMass link(JsonFields link) throws JsonException {
    double[] com = numbers(link, "comM", 3);
    double[] inertia = numbers(link, "inertiaKgM2", 6);
    try {
      return new LinkMass(
          link.text("name").value(),
          link.number("massKg", ANY),
          com[0],
          com[1],
          com[2],
          inertia[0],
          inertia[1],
          inertia[2],
          inertia[3],
          inertia[4],
          inertia[5]);
    } catch (IllegalArgumentException e) {
      throw link.place().refusal(e.getMessage());
    }
  }

  private static Confidence confidence(JsonFields status, String key) throws JsonException {
    Json.Text word = status.text(key);
    try {
      return Confidence.named(word.value());
    } catch (IllegalArgumentException e) {
      throw word.place().refusal(e.getMessage());
    }
  }

  private static double[] numbers(JsonFields fields, String key, int count) throws JsonException {
    List<Json> values = fields.numbers(key, count);
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = JsonFields.number(key, values.get(i), ANY);
    }
    return numbers;
  }
}
