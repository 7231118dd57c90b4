package org.pendant.models.shape;

import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Confidence;
import org.pendant.models.json.JsonObject;

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
    return read(JsonObject.ofResource(ArmLibrary.class, file));
  }

  /** Reads a whole file; an {@link IllegalStateException} says what is wrong with it. */
  static ArmShape read(JsonObject root) {
    try {
      return new ArmShape(
          root.text("id"),
          Confidence.named(root.text("status")),
          base(root.object("base")),
          knuckle(root.object("shoulder")),
          limb(root.object("upperArm")),
          limb(root.object("forearm")),
          knuckle(root.object("wrist1")),
          knuckle(root.object("wrist2")),
          knuckle(root.object("wrist3")));
    } catch (IllegalArgumentException e) {
      throw root.refused(e);
    }
  }

  private static Base base(JsonObject base) {
    return new Base(base.number("heightM"), base.number("footRadiusM"), base.number("topRadiusM"));
  }

  private static JointHousing knuckle(JsonObject knuckle) {
    double radiusM = knuckle.number("radiusM");
    double[] alongZ = knuckle.numbers("alongZM", 2);
    double[] alongY = knuckle.numbers("alongYM", 2);
    return new JointHousing(
        new Cylinder(radiusM, alongZ[0], alongZ[1]), new Cylinder(radiusM, alongY[0], alongY[1]));
  }

  private static Limb limb(JsonObject limb) {
    return new Limb(
        limb.number("lengthM"),
        housing(limb.object("near")),
        housing(limb.object("far")),
        tube(limb.object("tube")));
  }

  private static Cylinder housing(JsonObject housing) {
    double[] alongZ = housing.numbers("alongZM", 2);
    return new Cylinder(housing.number("radiusM"), alongZ[0], alongZ[1]);
  }

  private static Tube tube(JsonObject tube) {
    double[] radii = tube.numbers("radiiM", 3);
    return new Tube(tube.number("centreZM"), radii[0], radii[1], radii[2]);
  }
}
