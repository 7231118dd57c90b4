package org.pendant.motion.toolpath;

import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.motion.ToolCurve;

/**
 * Remote TCP curve: the path of the flange that carries a part along a tool which stands still:
 * {@code C W⁻¹} for the tool at C in the base and at W in the flange. With R the rotation of the
 * flange, p the place of the tool in the flange and (v, w) how it changes there, the flange turns
 * with {@code -R w} and moves with {@code R (w x p - v)}; the second derivatives follow by the
 * product rule.
 */
final class RemoteTcpCurve implements ToolCurve {
  private final ToolCurve inFlange;
  private final double[] tool = new double[Transforms.SIZE];
  private final double[] work = new double[Transforms.SIZE];
  private final double[] inverse = new double[Transforms.SIZE];
  private final double[] flange = new double[Transforms.SIZE];
  private final double[] first = new double[Pose.SIZE];
  private final double[] own = new double[Pose.SIZE];
  private double placedAt = Double.NaN;

  /**
   * A way.
   *
   * @param inFlange of the tool in the flange frame
   * @param toolInBase where it stands
   */
  RemoteTcpCurve(ToolCurve inFlange, Pose toolInBase) {
    this.inFlange = inFlange;
    Transforms.of(toolInBase, tool);
  }

  @Override
  public void at(double at, double[] transform) {
    place(at);
    System.arraycopy(flange, 0, transform, 0, Transforms.SIZE);
  }

  /** Finds the places at a point, unless it was the last one: rate and bend are asked there too. */
  private void place(double at) {
    if (at != placedAt) {
      inFlange.at(at, work);
      Transforms.invert(work, inverse);
      Transforms.multiply(tool, inverse, flange);
      placedAt = at;
    }
  }

  @Override
  public void rate(double at, double[] twist) {
    place(at);
    inFlange.rate(at, first);
    double x = first[4] * work[11] - first[5] * work[10] - first[0];
    double y = first[5] * work[9] - first[3] * work[11] - first[1];
    double z = first[3] * work[10] - first[4] * work[9] - first[2];
    turn(x, y, z, twist, 0);
    turn(-first[3], -first[4], -first[5], twist, 3);
  }

  @Override
  public void bend(double at, double[] twist) {
    place(at);
    inFlange.rate(at, first);
    inFlange.bend(at, own);
    double wx = first[3];
    double wy = first[4];
    double wz = first[5];
    // 2 v - w x p, of which w x makes what turning adds
    double ux = 2 * first[0] - (wy * work[11] - wz * work[10]);
    double uy = 2 * first[1] - (wz * work[9] - wx * work[11]);
    double uz = 2 * first[2] - (wx * work[10] - wy * work[9]);
    double x = wy * uz - wz * uy + own[4] * work[11] - own[5] * work[10] - own[0];
    double y = wz * ux - wx * uz + own[5] * work[9] - own[3] * work[11] - own[1];
    double z = wx * uy - wy * ux + own[3] * work[10] - own[4] * work[9] - own[2];
    turn(x, y, z, twist, 0);
    turn(-own[3], -own[4], -own[5], twist, 3);
  }

  /** Turns a vector from the flange into the base. */
  private void turn(double x, double y, double z, double[] twist, int offset) {
    for (int row = 0; row < 3; row++) {
      twist[offset + row] = flange[3 * row] * x + flange[3 * row + 1] * y + flange[3 * row + 2] * z;
    }
  }
}
