package org.pendant.motion;

import org.pendant.models.pose.Pose;

/**
 * Rounding of a corner by a circle, or by two that touch where the lengths before and after it
 * differ; its parameter is the distance along the path, m. The tool turns over from one way's even
 * turning to the other's.
 *
 * <p>Two arcs with given ends and directions are chosen so that both have the same distance to the
 * point where their tangents meet. (K. Bolton, "Biarc curves", Computer-Aided Design 7, 1975.)
 */
final class CornerArc implements ToolCurve {
  private final Arc first;
  private final Arc second;
  private final ToolBlend turn;

  private CornerArc(Arc first, Arc second, ToolBlend turn) {
    this.first = first;
    this.second = second;
    this.turn = turn;
  }

  /** The arcs from one point, left in a direction, to another one, reached in a direction. */
  static Arc[] arcs(double[] from, double[] leaving, double[] to, double[] reaching) {
    double[] way = Arc.minus(to, from);
    double square = Arc.dot(way, way);
    double along = Arc.dot(way, leaving) + Arc.dot(way, reaching);
    double bend = 2 * (1 - Arc.dot(leaving, reaching));
    double reach = square / (along + Math.sqrt(along * along + bend * square));
    double[] middle = new double[3];
    for (int i = 0; i < 3; i++) {
      middle[i] = 0.5 * (from[i] + to[i] + reach * (leaving[i] - reaching[i]));
    }
    Arc first = Arc.leaving(from, leaving, middle);
    double[] passing = new double[3];
    first.direction(first.length(), passing);
    return new Arc[] {first, Arc.leaving(middle, passing, to)};
  }

  /**
   * A curve.
   *
   * @param arcs two that touch
   * @param turn how the tool turns, as rotation vector from the corner's orientation, over the
   *     length of both arcs; coordinates 3 to 5
   * @param corner the waypoint between the ways, in the base frame
   */
  static CornerArc of(Arc[] arcs, Hermite turn, Pose corner) {
    return new CornerArc(arcs[0], arcs[1], new ToolBlend(turn, corner));
  }

  private Arc arc(double at) {
    return at <= first.length() ? first : second;
  }

  private double on(double at) {
    return at <= first.length() ? at : at - first.length();
  }

  @Override
  public void at(double at, double[] transform) {
    turn.at(at, transform);
    arc(at).place(on(at), transform, 9);
  }

  @Override
  public void rate(double at, double[] twist) {
    turn.rate(at, twist);
    arc(at).direction(on(at), twist);
  }

  @Override
  public void bend(double at, double[] twist) {
    turn.bend(at, twist);
    arc(at).bend(on(at), twist);
  }
}
