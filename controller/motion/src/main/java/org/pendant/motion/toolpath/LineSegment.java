package org.pendant.motion.toolpath;

import java.util.Arrays;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.StraightLine;
import org.pendant.motion.ToolCurve;

/** Line segment: a straight line on which the tool rotates evenly. */
final class LineSegment implements ToolCurve {
  private final StraightLine line;
  private final double length;
  private final Pose whole;

  /**
   * A line.
   *
   * @param length the parameter at its end, above 0
   */
  LineSegment(StraightLine line, double length) {
    this.line = line;
    this.length = length;
    whole = line.rate();
  }

  @Override
  public void at(double at, double[] transform) {
    line.at(at / length, transform);
  }

  @Override
  public void rate(double at, double[] twist) {
    for (int i = 0; i < Pose.SIZE; i++) {
      twist[i] = whole.get(i) / length;
    }
  }

  @Override
  public void bend(double at, double[] twist) {
    Arrays.fill(twist, 0);
  }
}
