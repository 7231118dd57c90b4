package org.pendant.models.collision;

/**
 * Tool solid: something with a shape of its own on the flange, in the flange's frame. What others
 * get into is its shape, and what it gets into others with are its edges.
 *
 * <p>For one thread, as its shape is.
 */
public final class ToolSolid {
  private final SolidShape shape;
  private final SolidEdges edges;
  private final double[] centre = new double[3];
  private final double reachM;
  private final double[] place3 = new double[3];
  private final double[] other3 = new double[3];
  private final double[] line6 = new double[6];

  /**
   * A solid.
   *
   * @param shape in the flange's frame
   * @param edges of its convex hull
   */
  public ToolSolid(SolidShape shape, SolidEdges edges) {
    this.shape = shape;
    this.edges = edges;
    double[] ends = edges.ends();
    double[] least = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
    double[] most = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
    for (int i = 0; i < ends.length; i++) {
      least[i % 3] = Math.min(least[i % 3], ends[i]);
      most[i % 3] = Math.max(most[i % 3], ends[i]);
    }
    for (int axis = 0; axis < 3; axis++) {
      centre[axis] = (least[axis] + most[axis]) / 2;
    }
    reachM = extentM(centre, 0);
  }

  /** One whose shape tells its edges: a block, a bar or a ball. */
  public ToolSolid(SolidShape shape) {
    this(shape, shape.edges());
  }

  /** The middle of a ball around it. */
  double centre(int axis) {
    return centre[axis];
  }

  /** The radius of that ball, m. */
  double reachM() {
    return reachM;
  }

  /** How far it reaches from a place, m. */
  double extentM(double[] from, int at) {
    double[] ends = edges.ends();
    double most = 0;
    for (int i = 0; i < ends.length; i += 3) {
      double x = ends[i] - from[at];
      double y = ends[i + 1] - from[at + 1];
      double z = ends[i + 2] - from[at + 2];
      most = Math.max(most, Math.sqrt(x * x + y * y + z * z));
    }
    return most + edges.radiusM();
  }

  /** How far a line is from it, m; the ends in the frame that the flange's frame is given in. */
  double toSegment(double[] flange12, double[] ends, int at) {
    own(flange12, ends, at, place3);
    own(flange12, ends, at + 3, other3);
    return shape.toSegment(place3[0], place3[1], place3[2], other3[0], other3[1], other3[2]);
  }

  /** How far an obstacle is from it, m; in the frame that the flange's frame is given in. */
  double toObstacle(double[] flange12, SolidShape obstacle) {
    double least = Double.POSITIVE_INFINITY;
    double[] ends = edges.ends();
    for (int i = 0; i < ends.length; i += 6) {
      placed(flange12, ends, i, place3, 0);
      placed(flange12, ends, i + 3, other3, 0);
      least =
          Math.min(
              least,
              obstacle.toSegment(place3[0], place3[1], place3[2], other3[0], other3[1], other3[2])
                  - edges.radiusM());
    }
    SolidEdges others = obstacle.edges();
    for (int i = 0; i < others.ends().length; i += 6) {
      least = Math.min(least, toSegment(flange12, others.ends(), i) - others.radiusM());
    }
    return least;
  }

  /**
   * How far a solid on another flange is from it, m; both flanges in one frame.
   *
   * @param farM from here on it need not be exact, m: the answer is then at least this, and at most
   *     the distance
   */
  double toTool(double[] flange12, ToolSolid other, double[] otherFlange12, double farM) {
    placed(flange12, centre, 0, place3, 0);
    placed(otherFlange12, other.centre, 0, other3, 0);
    double x = place3[0] - other3[0];
    double y = place3[1] - other3[1];
    double z = place3[2] - other3[2];
    double bound = Math.sqrt(x * x + y * y + z * z) - reachM - other.reachM;
    return bound >= farM
        ? bound
        : Math.min(
            edgesTo(flange12, other, otherFlange12), other.edgesTo(otherFlange12, this, flange12));
  }

  /** How far its edges are from another solid on a flange. */
  private double edgesTo(double[] flange12, ToolSolid other, double[] otherFlange12) {
    double least = Double.POSITIVE_INFINITY;
    double[] ends = edges.ends();
    for (int i = 0; i < ends.length; i += 6) {
      placed(flange12, ends, i, line6, 0);
      placed(flange12, ends, i + 3, line6, 3);
      least = Math.min(least, other.toSegment(otherFlange12, line6, 0) - edges.radiusM());
    }
    return least;
  }

  private static void own(double[] frame, double[] from, int at, double[] to) {
    double x = from[at] - frame[9];
    double y = from[at + 1] - frame[10];
    double z = from[at + 2] - frame[11];
    for (int axis = 0; axis < 3; axis++) {
      to[axis] = frame[axis] * x + frame[3 + axis] * y + frame[6 + axis] * z;
    }
  }

  private static void placed(double[] frame, double[] from, int at, double[] to, int toAt) {
    for (int row = 0; row < 3; row++) {
      to[toAt + row] =
          frame[9 + row]
              + frame[3 * row] * from[at]
              + frame[3 * row + 1] * from[at + 1]
              + frame[3 * row + 2] * from[at + 2];
    }
  }
}
