package org.pendant.models.shape;

import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Confidence;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;

/**
 * Shapes of the arms that come with the program, one JSON file each beside the descriptions. A
 * program that draws nothing never reads them.
 */
public final class ArmShapes {
  private ArmShapes() {}

  /**
   * Reads the shape of a model.
   *
   * @param name as {@link ArmLibrary#find} understands it
   * @throws IllegalArgumentException if there is no such model; the message names those there are
   */
  public static ArmShape load(String name) {
    String file = "shape/" + ArmLibrary.idOf(name) + ".json";
    try {
      return read(new JsonFields(JsonFile.ofResource(ArmLibrary.class, file), "a shape"));
    } catch (JsonException | IllegalArgumentException e) {
      throw new IllegalStateException(file + " is no shape: " + e.getMessage(), e);
    }
  }

  /**
   * Reads a whole file.
   *
   * @throws JsonException if a member is missing or of the wrong type
   * @throws IllegalArgumentException if there is no such body
   */
  static ArmShape read(JsonFields root) throws JsonException {
    return new ArmShape(
        root.text("id").value(),
        Confidence.named(root.text("status").value()),
        base(root.object("base")),
        knuckle(root.object("shoulder")),
        limb(root.object("upperArm")),
        limb(root.object("forearm")),
        knuckle(root.object("wrist1")),
        knuckle(root.object("wrist2")),
        knuckle(root.object("wrist3")));
  }

  private static Base base(JsonFields base) throws JsonException {
    return new Base(base.number("heightM"), base.number("footRadiusM"), base.number("topRadiusM"));
  }

  private static JointHousing knuckle(JsonFields knuckle) throws JsonException {
    double radiusM = knuckle.number("radiusM");
    double[] alongZ = knuckle.vector("alongZM", 2);
    double[] alongY = knuckle.vector("alongYM", 2);
    return new JointHousing(
        new Cylinder(radiusM, alongZ[0], alongZ[1]), new Cylinder(radiusM, alongY[0], alongY[1]));
  }

  private static Limb limb(JsonFields limb) throws JsonException {
    return new Limb(
        limb.number("lengthM"),
        housing(limb.object("near")),
        housing(limb.object("far")),
        tube(limb.object("tube")));
  }

  private static Cylinder housing(JsonFields housing) throws JsonException {
    double[] alongZ = housing.vector("alongZM", 2);
    return new Cylinder(housing.number("radiusM"), alongZ[0], alongZ[1]);
  }

  private static Tube tube(JsonFields tube) throws JsonException {
    double[] radii = tube.vector("radiiM", 3);
    return new Tube(tube.number("centreZM"), radii[0], radii[1], radii[2]);
  }
}
