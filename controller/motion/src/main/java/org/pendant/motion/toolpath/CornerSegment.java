package org.pendant.motion.toolpath;

import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;
import org.pendant.motion.ToolCurve;

/**
 * Corner segment: a blend from one segment to the next past the corner between them. It touches
 * both segments a distance l (in the parameter, which goes from 0 to 2 l) before and after the
 * corner. The place follows the cubic that has the ends and directions of both, between straight
 * lines a parabola. The orientation is {@code exp(u² l w2) exp(-(1-u)² l w1) R}, u going from 0 to
 * 1, R the orientation in the corner and w1, w2 how the tool turns on both ways: its turning is
 * {@code u w2 + (1-u) exp(u² l w2) w1}, which is that of the ways at both ends.
 */
final class CornerSegment implements ToolCurve {
  private final double reach;
  private final double[] corner = new double[Transforms.SIZE];
  private final double[] before = new double[Pose.SIZE];
  private final double[] after = new double[Pose.SIZE];

  /** Coefficients of the cubic in u, four for each coordinate. */
  private final double[] cubic = new double[12];

  private final double[] early = new double[Transforms.SIZE];
  private final double[] late = new double[Transforms.SIZE];
  private final double[] product = new double[Transforms.SIZE];
  private final double[] turned = new double[3];

  /**
   * A way past a corner.
   *
   * @param in the way that ends in the corner
   * @param inLength its length
   * @param out the way that begins there
   * @param reach how far before and after the corner it touches them, above 0
   */
  CornerSegment(ToolCurve in, double inLength, ToolCurve out, double reach) {
    this.reach = reach;
    in.at(inLength, corner);
    double[] from = new double[Transforms.SIZE];
    double[] to = new double[Transforms.SIZE];
    in.at(inLength - reach, from);
    in.rate(inLength - reach, before);
    out.at(reach, to);
    out.rate(reach, after);
    for (int i = 0; i < 3; i++) {
      double step = to[9 + i] - from[9 + i];
      double v0 = 2 * reach * before[i];
      double v1 = 2 * reach * after[i];
      cubic[4 * i] = from[9 + i];
      cubic[4 * i + 1] = v0;
      cubic[4 * i + 2] = 3 * step - 2 * v0 - v1;
      cubic[4 * i + 3] = v0 + v1 - 2 * step;
    }
  }

  @Override
  public void at(double at, double[] transform) {
    double u = at / (2 * reach);
    double left = 1 - u;
    turning(-left * left * reach, before, early);
    Transforms.multiply(early, corner, product);
    turning(u * u * reach, after, late);
    Transforms.multiply(late, product, transform);
    for (int i = 0; i < 3; i++) {
      int c = 4 * i;
      transform[9 + i] = cubic[c] + u * (cubic[c + 1] + u * (cubic[c + 2] + u * cubic[c + 3]));
    }
  }

  private static void turning(double f, double[] twist, double[] matrix) {
    Rotations.vectorToMatrix(f * twist[3], f * twist[4], f * twist[5], matrix);
  }

  /** The turning of the way before, turned on by that of the way after. */
  private void turnOn(double u) {
    turning(u * u * reach, after, late);
    for (int row = 0; row < 3; row++) {
      turned[row] =
          late[3 * row] * before[3] + late[3 * row + 1] * before[4] + late[3 * row + 2] * before[5];
    }
  }

  @Override
  public void rate(double at, double[] twist) {
    double u = at / (2 * reach);
    turnOn(u);
    for (int i = 0; i < 3; i++) {
      int c = 4 * i;
      twist[i] = (cubic[c + 1] + u * (2 * cubic[c + 2] + u * 3 * cubic[c + 3])) / (2 * reach);
      twist[3 + i] = u * after[3 + i] + (1 - u) * turned[i];
    }
  }

  @Override
  public void bend(double at, double[] twist) {
    double u = at / (2 * reach);
    turnOn(u);
    double f = u * (1 - u);
    double x = after[4] * turned[2] - after[5] * turned[1];
    double y = after[5] * turned[0] - after[3] * turned[2];
    double z = after[3] * turned[1] - after[4] * turned[0];
    for (int i = 0; i < 3; i++) {
      twist[i] = (2 * cubic[4 * i + 2] + 6 * u * cubic[4 * i + 3]) / (4 * reach * reach);
      twist[3 + i] = (after[3 + i] - turned[i]) / (2 * reach);
    }
    twist[3] += f * x;
    twist[4] += f * y;
    twist[5] += f * z;
  }
}
