package org.pendant.models.collision;

import org.pendant.models.mesh.ConvexHull;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Solid edges: the lines along which a solid without dents first meets another one, with a radius
 * where it is round. Immutable; lengths in m, in the frame of the pose.
 */
public final class SolidEdges {
  /** Of a solid that has none. */
  static final SolidEdges NONE = new SolidEdges(new double[0], 0);

  /** Sides of a cylinder's rims; between them it is thinner by 0.5 % of its radius. */
  private static final int SIDES = 32;

  private final double[] ends;
  private final double radiusM;

  private SolidEdges(double[] ends, double radiusM) {
    this.ends = ends;
    this.radiusM = radiusM;
  }

  /** A line from one place of a pose's z axis to the other, all around which is solid. */
  static SolidEdges axis(Pose pose, double lengthM, double radiusM) {
    double[] frame = new double[Transforms.SIZE];
    Transforms.of(pose, frame);
    double[] ends = new double[6];
    for (int row = 0; row < 3; row++) {
      ends[row] = frame[9 + row] - frame[3 * row + 2] * lengthM / 2;
      ends[3 + row] = frame[9 + row] + frame[3 * row + 2] * lengthM / 2;
    }
    return new SolidEdges(ends, radiusM);
  }

  static SolidEdges block(Pose pose, double x, double y, double z) {
    return of(pose, ConvexHull.block(x, y, z));
  }

  static SolidEdges cylinder(Pose pose, double radiusM, double lengthM) {
    return of(pose, ConvexHull.prism(SIDES, radiusM, lengthM));
  }

  /** The edges of a hull whose origin is at a pose. */
  public static SolidEdges of(Pose pose, ConvexHull hull) {
    double[] frame = new double[Transforms.SIZE];
    Transforms.of(pose, frame);
    double[] ends = new double[6 * hull.edges()];
    for (int edge = 0; edge < hull.edges(); edge++) {
      for (int end = 0; end < 2; end++) {
        int corner = hull.edge(edge, end);
        for (int row = 0; row < 3; row++) {
          ends[6 * edge + 3 * end + row] =
              frame[9 + row]
                  + frame[3 * row] * hull.coordinate(corner, 0)
                  + frame[3 * row + 1] * hull.coordinate(corner, 1)
                  + frame[3 * row + 2] * hull.coordinate(corner, 2);
        }
      }
    }
    return new SolidEdges(ends, 0);
  }

  /** Ends of all lines, six numbers each; not to be changed. */
  double[] ends() {
    return ends;
  }

  /** How far it reaches from them, m. */
  double radiusM() {
    return radiusM;
  }
}
