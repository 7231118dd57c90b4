package org.pendant.motion.servo;

/**
 * Tangent arc: leaves a point in a given direction and leads to another point; a straight line if
 * that lies straight ahead. Its parameter is the way along it, m.
 */
final class TangentArc {
  /** Angle between direction and chord, rad, below which the arc is a line. */
  private static final double STRAIGHT_RAD = 1e-6;

  private final double[] start;
  private final double[] ahead;

  /** Towards the centre, at right angles to {@link #ahead}. */
  private final double[] inward = new double[3];

  private final double angleRad;
  private final double curvature;
  private final double length;

  /**
   * An arc.
   *
   * @param start three coordinates, m
   * @param direction unit vector
   * @param end three coordinates, m
   */
  TangentArc(double[] start, double[] direction, double[] end) {
    this.start = start;
    double[] chord = {end[0] - start[0], end[1] - start[1], end[2] - start[2]};
    double distance = length(chord);
    double along = dot(chord, direction);
    for (int i = 0; i < 3; i++) {
      inward[i] = chord[i] - along * direction[i];
    }
    double aside = length(inward);
    angleRad = Math.atan2(aside, along);
    if (angleRad < STRAIGHT_RAD || distance == 0) {
      ahead = distance == 0 ? direction : scaled(chord, 1 / distance);
      curvature = 0;
      length = distance;
      return;
    }
    ahead = direction;
    for (int i = 0; i < 3; i++) {
      inward[i] /= aside;
    }
    // the chord is seen under twice its angle with the tangent
    curvature = 2 * Math.sin(angleRad) / distance;
    length = 2 * angleRad / curvature;
  }

  static double length(double[] v) {
    return Math.sqrt(dot(v, v));
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private static double[] scaled(double[] v, double factor) {
    return new double[] {factor * v[0], factor * v[1], factor * v[2]};
  }

  /** Angle between the direction and the way to the end, rad, 0 to pi. */
  double angleRad() {
    return angleRad;
  }

  /** One over the radius, 1/m; 0 for a line. */
  double curvature() {
    return curvature;
  }

  /** The whole way, m. */
  double length() {
    return length;
  }

  /** Writes the point at a way to {@code transform[9..11]}. */
  void at(double way, double[] transform) {
    double turned = curvature * way;
    double forth = curvature == 0 ? way : Math.sin(turned) / curvature;
    double half = Math.sin(0.5 * turned);
    double aside = curvature == 0 ? 0 : 2 * half * half / curvature;
    for (int i = 0; i < 3; i++) {
      transform[9 + i] = start[i] + forth * ahead[i] + aside * inward[i];
    }
  }

  /** Writes the velocity at a way for a speed along it to {@code twist[0..2]}. */
  void velocity(double way, double speed, double[] twist) {
    double turned = curvature * way;
    for (int i = 0; i < 3; i++) {
      twist[i] = speed * (Math.cos(turned) * ahead[i] + Math.sin(turned) * inward[i]);
    }
  }

  /** Writes the acceleration at a way for a speed and its change to {@code twist[0..2]}. */
  void acceleration(double way, double speed, double change, double[] twist) {
    double turned = curvature * way;
    double centripetal = speed * speed * curvature;
    for (int i = 0; i < 3; i++) {
      twist[i] =
          change * (Math.cos(turned) * ahead[i] + Math.sin(turned) * inward[i])
              + centripetal * (Math.cos(turned) * inward[i] - Math.sin(turned) * ahead[i]);
    }
  }
}
