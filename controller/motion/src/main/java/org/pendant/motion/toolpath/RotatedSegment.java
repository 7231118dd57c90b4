package org.pendant.motion.toolpath;

import org.pendant.models.pose.Transforms;
import org.pendant.motion.ToolCurve;

/**
 * Rotated segment: a segment on which the tool also rotates about its own z-axis: with t the angle,
 * z the axis and w the angular rate of the segment it turns with {@code w + t' z}.
 */
final class RotatedSegment implements ToolCurve {
  private final ToolCurve plain;
  private final Spline angle;
  private final double[] frame = new double[Transforms.SIZE];
  private final double[] turning = new double[6];
  private double placedAt = Double.NaN;

  RotatedSegment(ToolCurve plain, Spline angle) {
    this.plain = plain;
    this.angle = angle;
  }

  @Override
  public void at(double at, double[] transform) {
    place(at);
    System.arraycopy(frame, 0, transform, 0, Transforms.SIZE);
    spin(transform, angle.value(at));
  }

  /** Finds the place at a point, unless it was the last one: rate and bend are asked there too. */
  private void place(double at) {
    if (at != placedAt) {
      plain.at(at, frame);
      placedAt = at;
    }
  }

  /** Turns a transformation about its z-axis. */
  static void spin(double[] transform, double angleRad) {
    double cos = Math.cos(angleRad);
    double sin = Math.sin(angleRad);
    for (int row = 0; row < 9; row += 3) {
      double x = transform[row];
      double y = transform[row + 1];
      transform[row] = cos * x + sin * y;
      transform[row + 1] = cos * y - sin * x;
    }
  }

  @Override
  public void rate(double at, double[] twist) {
    place(at);
    plain.rate(at, twist);
    double slope = angle.slope(at);
    twist[3] += slope * frame[2];
    twist[4] += slope * frame[5];
    twist[5] += slope * frame[8];
  }

  @Override
  public void bend(double at, double[] twist) {
    place(at);
    plain.rate(at, turning);
    plain.bend(at, twist);
    double slope = angle.slope(at);
    double bend = angle.bend(at);
    double x = frame[2];
    double y = frame[5];
    double z = frame[8];
    twist[3] += bend * x + slope * (turning[4] * z - turning[5] * y);
    twist[4] += bend * y + slope * (turning[5] * x - turning[3] * z);
    twist[5] += bend * z + slope * (turning[3] * y - turning[4] * x);
  }
}
