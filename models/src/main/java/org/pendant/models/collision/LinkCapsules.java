package org.pendant.models.collision;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.shape.ArmShape;
import org.pendant.models.shape.ArmShapes;
import org.pendant.models.shape.Cylinder;
import org.pendant.models.shape.JointHousing;
import org.pendant.models.shape.Limb;
import org.pendant.models.shape.Tube;

/**
 * Link capsules: the bodies of an arm as capsules, of the cylinders of its {@link ArmShape}.
 *
 * <p>A capsule has the radius of its cylinder and ends where it does, so that the rim of a flat end
 * is rounded off, as the covers of real joints are. A cylinder that is shorter than it is wide
 * becomes two capsules across its axis, at right angles, as thick as it is long. The base and tubes
 * have the largest of their radii. The socket across wrist 3 is left out.
 */
public final class LinkCapsules {
  /** The texts of what the bodies are called; what is mounted on the flange is the last. */
  private static final List<String> KEYS =
      List.of("base", "shoulder", "upperArm", "forearm", "wrist1", "wrist2", "wrist3", "tool");

  /** How many bodies there are, with what is mounted on the flange. */
  public static final int BODIES = KEYS.size();

  /** The body that stands still. */
  public static final int BASE = 0;

  /** The number of the upper arm. */
  public static final int UPPER_ARM = 2;

  /** The body whose face the tool is mounted on. */
  public static final int WRIST_3 = 6;

  /** What is mounted on the flange. */
  public static final int TOOL = 7;

  /** Angle between the axes before and after each body, in quarter turns. */
  private static final int[] QUARTERS = {0, 1, 0, 0, 1, -1, 0};

  private LinkCapsules() {}

  /**
   * What a body is called, as in {@code upper arm}.
   *
   * @param body 0 to {@link #BODIES} - 1
   */
  public static String name(int body) {
    return CollisionTexts.text(KEYS.get(body));
  }

  /**
   * The bodies of an arm, base first: those of the base in the base frame, others in the
   * Denavit-Hartenberg frame behind their joint. Empty for an arm of which no shape is known.
   */
  public static List<Capsule> of(ArmDescription arm) {
    Optional<String> known = ArmLibrary.find(arm.id());
    return known.isPresent() ? of(ArmShapes.load(known.get()), arm.dh()) : List.of();
  }

  static List<Capsule> of(ArmShape shape, DhLengths dh) {
    List<Capsule> capsules = new ArrayList<>();
    double footM = Math.max(shape.base().footRadiusM(), shape.base().topRadiusM());
    double topM = Math.max(0, shape.base().heightM() - footM);
    capsules.add(new Capsule(BASE, 0, 0, 0, 0, 0, topM, footM));
    add(capsules, 1, shape.shoulder());
    add(capsules, 2, shape.upperArm(), -dh.a2());
    add(capsules, 3, shape.forearm(), -dh.a3());
    add(capsules, 4, shape.wrist1());
    add(capsules, 5, shape.wrist2());
    addAlongZ(capsules, WRIST_3, 0, shape.wrist3().alongZ());
    return List.copyOf(capsules);
  }

  private static void add(List<Capsule> capsules, int body, JointHousing housing) {
    addAlongZ(capsules, body, 0, housing.alongZ());
    Cylinder across = housing.alongY();
    double middle = middle(across);
    double inside = half(across) - across.radiusM();
    if (inside >= 0) {
      double from = middle - inside;
      double to = middle + inside;
      capsules.add(inLink(body, 0, from, 0, 0, to, 0, across.radiusM()));
    } else {
      double half = half(across);
      capsules.add(inLink(body, inside, middle, 0, -inside, middle, 0, half));
      capsules.add(inLink(body, 0, middle, inside, 0, middle, -inside, half));
    }
  }

  /** A limb, which lies along negative x of its near end, whose frame is at its far end. */
  private static void add(List<Capsule> capsules, int body, Limb limb, double lengthM) {
    addAlongZ(capsules, body, lengthM, limb.near());
    addAlongZ(capsules, body, 0, limb.far());
    Tube tube = limb.tube();
    double radius = Math.max(tube.nearRadiusM(), Math.max(tube.middleRadiusM(), tube.farRadiusM()));
    capsules.add(inLink(body, lengthM, 0, tube.centreZM(), 0, 0, tube.centreZM(), radius));
  }

  private static void addAlongZ(List<Capsule> capsules, int body, double x, Cylinder cylinder) {
    double middle = middle(cylinder);
    double inside = half(cylinder) - cylinder.radiusM();
    if (inside >= 0) {
      double from = middle - inside;
      double to = middle + inside;
      capsules.add(inLink(body, x, 0, from, x, 0, to, cylinder.radiusM()));
    } else {
      double half = half(cylinder);
      capsules.add(inLink(body, x + inside, 0, middle, x - inside, 0, middle, half));
      capsules.add(inLink(body, x, inside, middle, x, -inside, middle, half));
    }
  }

  private static double middle(Cylinder cylinder) {
    return (cylinder.fromM() + cylinder.toM()) / 2;
  }

  private static double half(Cylinder cylinder) {
    return (cylinder.toM() - cylinder.fromM()) / 2;
  }

  /** A capsule given along the axis of the body's own joint, in the frame of its next joint. */
  private static Capsule inLink(
      int body, double ax, double ay, double az, double bx, double by, double bz, double radiusM) {
    int sine = QUARTERS[body];
    int cosine = 1 - Math.abs(sine);
    return new Capsule(
        body,
        ax,
        cosine * ay + sine * az,
        cosine * az - sine * ay,
        bx,
        cosine * by + sine * bz,
        cosine * bz - sine * by,
        radiusM);
  }
}
