package org.pendant.controller.installation;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Feature poses: where features are, from the points by which they were taught.
 *
 * <p>A point is its own frame. A line has its origin in the first point, y towards the second, and
 * z as near as possible to the z axis of the first point; when that axis lies along the line, the x
 * axis of the first point is taken for it. A plane has its origin in the first point, x towards the
 * second, and z upright on the plane so that the third point has a positive y.
 */
public final class FeaturePoses {
  /** Points closer than this, m, give no direction: a taught pose is not known any better. */
  private static final double NEAREST_M = 1e-5;

  /** Sine of the angle below which two directions are taken for the same. */
  private static final double MIN_SINE = 1e-6;

  private FeaturePoses() {}

  /**
   * The frame of a feature in the base frame; empty while it has too few points, or when these lie
   * in one place or, for a plane, on one line.
   */
  public static Optional<Pose> pose(Feature feature) {
    List<Pose> points = feature.points();
    if (points.size() != feature.kind().points()
        || !points.stream().allMatch(FeaturePoses::isFinite)) {
      return Optional.empty();
    }
    return switch (feature.kind()) {
      case POINT -> Optional.of(points.getFirst());
      case LINE -> line(points.get(0), points.get(1));
      case PLANE -> plane(points.get(0), points.get(1), points.get(2));
    };
  }

  private static boolean isFinite(Pose point) {
    return Arrays.stream(point.toArray()).allMatch(Double::isFinite);
  }

  private static Optional<Pose> line(Pose first, Pose second) {
    double[] y = between(first, second);
    if (norm(y) < NEAREST_M) {
      return Optional.empty();
    }
    scale(y);
    double[] z = upright(axis(first, 2), y);
    if (norm(z) < MIN_SINE) {
      z = upright(axis(first, 0), y);
    }
    scale(z);
    return Optional.of(frame(first, cross(y, z), y, z));
  }

  private static Optional<Pose> plane(Pose origin, Pose onX, Pose beside) {
    double[] x = between(origin, onX);
    double[] side = between(origin, beside);
    if (norm(x) < NEAREST_M || norm(side) < NEAREST_M) {
      return Optional.empty();
    }
    scale(x);
    scale(side);
    double[] z = cross(x, side);
    if (norm(z) < MIN_SINE) {
      return Optional.empty();
    }
    scale(z);
    return Optional.of(frame(origin, x, cross(z, x), z));
  }

  private static double[] between(Pose from, Pose to) {
    return new double[] {to.x() - from.x(), to.y() - from.y(), to.z() - from.z()};
  }

  /** Axis 0 to 2 of a frame, seen from the base. */
  private static double[] axis(Pose frame, int number) {
    double[] transform = new double[Transforms.SIZE];
    Transforms.of(frame, transform);
    return new double[] {transform[number], transform[3 + number], transform[6 + number]};
  }

  /** What of {@code v} is at right angles to the unit vector {@code along}. */
  private static double[] upright(double[] v, double[] along) {
    double part = v[0] * along[0] + v[1] * along[1] + v[2] * along[2];
    return new double[] {v[0] - part * along[0], v[1] - part * along[1], v[2] - part * along[2]};
  }

  private static double[] cross(double[] a, double[] b) {
    return new double[] {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    };
  }

  private static double norm(double[] v) {
    return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }

  private static void scale(double[] v) {
    double norm = norm(v);
    for (int i = 0; i < v.length; i++) {
      v[i] /= norm;
    }
  }

  private static Pose frame(Pose at, double[] x, double[] y, double[] z) {
    return Transforms.toPose(
        new double[] {
          x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2], at.x(), at.y(), at.z()
        });
  }
}
