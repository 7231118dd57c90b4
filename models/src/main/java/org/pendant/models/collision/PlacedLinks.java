package org.pendant.models.collision;

import java.util.List;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Placed links: the bodies of an arm that stands somewhere in a cell, to be compared with those of
 * another arm there. All lengths in m, in the frame of the cell.
 *
 * <p>Mutable, for one thread; allocates nothing after it was made.
 */
public final class PlacedLinks {
  private final ArmClearance arm;
  private final double[] base12 = new double[Transforms.SIZE];
  private final double[] ends;
  private final double[] centre;
  private final double[] flange12 = new double[Transforms.SIZE];
  private double travelledM;

  /**
   * An arm with all joints at 0.
   *
   * @param capsules what its bodies are made of, those of the tool included
   * @param tool solids on the flange
   * @param baseInCell where it stands
   */
  public PlacedLinks(
      ArmDescription of, List<Capsule> capsules, List<ToolSolid> tool, Pose baseInCell) {
    arm = new ArmClearance(of, capsules, tool, List.of());
    Transforms.of(baseInCell, base12);
    ends = new double[arm.ends().length];
    centre = new double[arm.centres().length];
    place();
  }

  /** Takes six joint positions, rad. */
  public void at(double[] positionRad) {
    double travelM = arm.travelM(positionRad);
    if (travelM > 0) {
      travelledM += travelM;
      arm.at(positionRad);
      place();
    }
  }

  private void place() {
    toCell(arm.ends(), ends);
    toCell(arm.centres(), centre);
    Transforms.multiply(base12, arm.flange12(), flange12);
  }

  private void toCell(double[] inBase, double[] inCell) {
    for (int at = 0; at < inBase.length; at += 3) {
      for (int row = 0; row < 3; row++) {
        inCell[at + row] =
            base12[9 + row]
                + base12[3 * row] * inBase[at]
                + base12[3 * row + 1] * inBase[at + 1]
                + base12[3 * row + 2] * inBase[at + 2];
      }
    }
  }

  /** How far its points have travelled at most since it was made, m. */
  public double travelledM() {
    return travelledM;
  }

  /** Whether a body has a shape. */
  public boolean has(int body) {
    return arm.has(body);
  }

  /**
   * How far a body is from one of another arm, m: below 0 by the depth where they overlap.
   *
   * @param farM from here on it need not be exact, m: the answer is then at least this, and at most
   *     the distance
   */
  public double apartM(int body, PlacedLinks other, int otherBody, double farM) {
    double x = centre[3 * body] - other.centre[3 * otherBody];
    double y = centre[3 * body + 1] - other.centre[3 * otherBody + 1];
    double z = centre[3 * body + 2] - other.centre[3 * otherBody + 2];
    double bound =
        Math.sqrt(x * x + y * y + z * z) - arm.aroundM(body) - other.arm.aroundM(otherBody);
    if (bound >= farM) {
      return bound;
    }
    double least = Double.POSITIVE_INFINITY;
    for (int i = arm.firstCapsule(body); i < arm.firstCapsule(body + 1); i++) {
      for (int j = other.arm.firstCapsule(otherBody);
          j < other.arm.firstCapsule(otherBody + 1);
          j++) {
        least = Math.min(least, ArmClearance.apartM(arm, ends, i, other.arm, other.ends, j));
      }
    }
    if (body == LinkCapsules.TOOL) {
      least = Math.min(least, toolToM(other, otherBody));
    }
    if (body == LinkCapsules.TOOL && otherBody == LinkCapsules.TOOL) {
      least = Math.min(least, toToolM(other, Math.min(least, farM)));
    }
    return otherBody == LinkCapsules.TOOL ? Math.min(least, other.toolToM(this, body)) : least;
  }

  /** How far the solids on the flange are from those on that of another arm, m. */
  private double toToolM(PlacedLinks other, double farM) {
    double least = farM;
    for (int i = 0; i < arm.tool().size(); i++) {
      for (int j = 0; j < other.arm.tool().size(); j++) {
        least =
            Math.min(
                least,
                arm.tool().get(i).toTool(flange12, other.arm.tool().get(j), other.flange12, least));
      }
    }
    return least;
  }

  /** How far the solids on the flange are from the capsules of a body of another arm, m. */
  private double toolToM(PlacedLinks other, int otherBody) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < arm.tool().size(); i++) {
      ToolSolid solid = arm.tool().get(i);
      int end = other.arm.firstCapsule(otherBody + 1);
      for (int j = other.arm.firstCapsule(otherBody); j < end; j++) {
        least =
            Math.min(least, solid.toSegment(flange12, other.ends, 6 * j) - other.arm.radiusM(j));
      }
    }
    return least;
  }
}
