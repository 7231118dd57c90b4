package org.pendant.motion;

import java.util.Arrays;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.StraightLine;

/** Straight line of the TCP on which the orientation turns evenly; its parameter is in m. */
final class ToolLine implements ToolCurve {
  private final StraightLine line;
  private final double perLength;
  private final double[] rate = new double[Pose.SIZE];

  /**
   * A line.
   *
   * @param length the parameter at its end, above 0
   */
  ToolLine(StraightLine line, double length) {
    this.line = line;
    perLength = 1 / length;
    Pose whole = line.rate();
    for (int i = 0; i < Pose.SIZE; i++) {
      rate[i] = whole.get(i) * perLength;
    }
  }

  @Override
  public void at(double at, double[] transform) {
    line.at(at * perLength, transform);
  }

  @Override
  public void rate(double at, double[] twist) {
    System.arraycopy(rate, 0, twist, 0, Pose.SIZE);
  }

  @Override
  public void bend(double at, double[] twist) {
    Arrays.fill(twist, 0);
  }
}
