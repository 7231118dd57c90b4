package org.pendant.motion;

import java.util.Arrays;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.StraightLine;

/**
 * Tool arc: the TCP follows an arc and the tool turns evenly about one axis; the parameter is in
 * the unit of the path.
 */
final class ToolArc implements ToolCurve {
  private final Arc arc;
  private final double metres;
  private final StraightLine turn;
  private final double[] turning = new double[3];
  private final double span;

  /**
   * A curve.
   *
   * @param turn orientations only: of the start, and of where the parameter is {@code span}
   * @param metres on the arc for each unit of the parameter
   */
  ToolArc(Arc arc, double metres, StraightLine turn, double span) {
    this.arc = arc;
    this.metres = metres;
    this.turn = turn;
    this.span = span;
    Pose whole = turn.rate();
    turning[0] = whole.rx() / span;
    turning[1] = whole.ry() / span;
    turning[2] = whole.rz() / span;
  }

  @Override
  public void at(double at, double[] transform) {
    turn.at(at / span, transform);
    arc.place(metres * at, transform, 9);
  }

  @Override
  public void rate(double at, double[] twist) {
    arc.direction(metres * at, twist);
    for (int i = 0; i < 3; i++) {
      twist[i] *= metres;
      twist[3 + i] = turning[i];
    }
  }

  @Override
  public void bend(double at, double[] twist) {
    Arrays.fill(twist, 0);
    arc.bend(metres * at, twist);
    for (int i = 0; i < 3; i++) {
      twist[i] *= metres * metres;
    }
  }
}
