package org.pendant.motion.toolpath;

import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.StraightLine;
import org.pendant.models.pose.Transforms;
import org.pendant.motion.ToolCurve;

/**
 * Arc segment: a circular arc through three points on which the tool rotates evenly about one axis:
 * from one orientation to another, or with the tangent.
 */
final class ArcSegment implements ToolCurve {
  /** Sine of the angle at the start below which three points are in a line. */
  private static final double STRAIGHT = 1e-6;

  private final double[] centre = new double[3];

  /** From the centre to the start. */
  private final double[] out = new double[3];

  /** A quarter of a turn further. */
  private final double[] ahead = new double[3];

  private final double angleRad;
  private final double radiusM;
  private final double[] begin = new double[Transforms.SIZE];
  private final double[] turn = new double[Transforms.SIZE];
  private final double[] turning = new double[3];
  private double length = 1;

  private ArcSegment(Pose from, Pose to, double[] fromCentre, double[] axis) {
    double[] end = new double[3];
    for (int i = 0; i < 3; i++) {
      centre[i] = from.get(i) - fromCentre[i];
      out[i] = fromCentre[i];
      end[i] = to.get(i) - centre[i];
    }
    System.arraycopy(cross(axis, out), 0, ahead, 0, 3);
    double angle = Math.atan2(dot(ahead, end), dot(out, end));
    angleRad = angle > 0 ? angle : angle + 2 * Math.PI;
    radiusM = Math.sqrt(dot(out, out));
    Transforms.of(from, begin);
  }

  /**
   * The arc from one point through another to a third (manual 20.2).
   *
   * @param withTangent whether the tool keeps its orientation to the tangent; else it turns evenly
   *     to that of {@code to}
   * @return empty if the three are in a line
   */
  static Optional<ArcSegment> through(Pose from, Pose via, Pose to, boolean withTangent) {
    double[] a = difference(via, from);
    double[] b = difference(to, from);
    double[] normal = cross(a, b);
    double square = dot(normal, normal);
    double aa = dot(a, a);
    double bb = dot(b, b);
    if (!(square > STRAIGHT * STRAIGHT * aa * bb)) {
      return Optional.empty();
    }
    // c = ((|a|² b - |b|² a) x n) / 2 |n|², from the start (triangle's circumcentre)
    double[] mixed = new double[3];
    for (int i = 0; i < 3; i++) {
      mixed[i] = aa * b[i] - bb * a[i];
    }
    double[] toCentre = cross(mixed, normal);
    double[] axis = new double[3];
    for (int i = 0; i < 3; i++) {
      toCentre[i] = -toCentre[i] / (2 * square);
      axis[i] = normal[i] / Math.sqrt(square);
    }
    ArcSegment arc = new ArcSegment(from, to, toCentre, axis);
    Pose line = new StraightLine(from, to).rate();
    for (int i = 0; i < 3; i++) {
      arc.turning[i] = withTangent ? axis[i] * arc.angleRad : line.get(3 + i);
    }
    return Optional.of(arc);
  }

  /** Length of the arc, m. */
  double arcM() {
    return radiusM * angleRad;
  }

  /** How far the tool turns on it, rad. */
  double turnRad() {
    return Math.sqrt(dot(turning, turning));
  }

  /** Sets what the parameter is at its end. */
  ArcSegment over(double wholeLength) {
    length = wholeLength;
    return this;
  }

  /** The pose at the end. */
  Pose end() {
    double[] last = new double[Transforms.SIZE];
    at(length, last);
    return Transforms.toPose(last);
  }

  @Override
  public void at(double at, double[] transform) {
    double f = at / length;
    Rotations.vectorToMatrix(f * turning[0], f * turning[1], f * turning[2], turn);
    Transforms.multiply(turn, begin, transform);
    double cos = Math.cos(f * angleRad);
    double sin = Math.sin(f * angleRad);
    for (int i = 0; i < 3; i++) {
      transform[9 + i] = centre[i] + cos * out[i] + sin * ahead[i];
    }
  }

  @Override
  public void rate(double at, double[] twist) {
    double angle = at / length * angleRad;
    double perLength = angleRad / length;
    double cos = Math.cos(angle) * perLength;
    double sin = Math.sin(angle) * perLength;
    for (int i = 0; i < 3; i++) {
      twist[i] = cos * ahead[i] - sin * out[i];
      twist[3 + i] = turning[i] / length;
    }
  }

  @Override
  public void bend(double at, double[] twist) {
    double angle = at / length * angleRad;
    double perLength = angleRad / length;
    double cos = Math.cos(angle) * perLength * perLength;
    double sin = Math.sin(angle) * perLength * perLength;
    for (int i = 0; i < 3; i++) {
      twist[i] = -cos * out[i] - sin * ahead[i];
      twist[3 + i] = 0;
    }
  }

  private static double[] difference(Pose a, Pose b) {
    return new double[] {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private static double[] cross(double[] a, double[] b) {
    return new double[] {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    };
  }
}
