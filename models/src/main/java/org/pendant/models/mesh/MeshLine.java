package org.pendant.models.mesh;

/**
 * Mesh line: how near a straight line comes to the surface of a mesh, and where it enters.
 * Allocates nothing after it was made; for one thread at a time.
 */
public final class MeshLine {
  /** Lines that come nearer than this cross the surface, m. */
  private static final double CROSSING_M = 1e-9;

  /** So many parts of a line are looked at for its deepest point, and so often in the best one. */
  private static final int PARTS = 32;

  private static final int ROUNDS = 24;

  /** What a step of the search leaves of the part where the deepest point may be. */
  private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

  private final MeshTree tree;
  private final MeshDistance distance;
  private final TrianglePoint nearest = new TrianglePoint();
  private final double[] ends = new double[6];
  private final double[] edge = new double[6];
  private final double[] along = new double[3];
  private final double[] unused = new double[3];
  private double leastM;

  /** Lines among the triangles of a mesh. */
  public MeshLine(TriangleMesh mesh) {
    tree = mesh.tree();
    distance = new MeshDistance(mesh);
  }

  /** How far a line from a to b is away, m: below 0 by the depth of its deepest point. */
  public double apartM(double ax, double ay, double az, double bx, double by, double bz) {
    set(ax, ay, az, bx - ax, by - ay, bz - az);
    leastM = Double.POSITIVE_INFINITY;
    visit(0);
    if (leastM > CROSSING_M && distance.toPoint(ax, ay, az, unused) >= 0) {
      return leastM;
    }
    return deepestM();
  }

  /**
   * How far a ray goes until it meets a triangle, in lengths of its direction; infinite if never.
   */
  public double meets(double[] from3, double[] direction3) {
    set(from3[0], from3[1], from3[2], direction3[0], direction3[1], direction3[2]);
    leastM = Double.POSITIVE_INFINITY;
    shoot(0);
    return leastM;
  }

  private void set(double ax, double ay, double az, double dx, double dy, double dz) {
    ends[0] = ax;
    ends[1] = ay;
    ends[2] = az;
    ends[3] = ax + dx;
    ends[4] = ay + dy;
    ends[5] = az + dz;
    along[0] = dx;
    along[1] = dy;
    along[2] = dz;
  }

  private double deepestM() {
    int best = 0;
    double leastAt = depthAt(0);
    for (int i = 1; i <= PARTS; i++) {
      double at = depthAt(i / (double) PARTS);
      if (at < leastAt) {
        leastAt = at;
        best = i;
      }
    }
    double from = Math.max(0, best - 1) / (double) PARTS;
    double to = Math.min(PARTS, best + 1) / (double) PARTS;
    for (int round = 0; round < ROUNDS; round++) {
      double left = to - GOLDEN * (to - from);
      double right = from + GOLDEN * (to - from);
      double atLeft = depthAt(left);
      double atRight = depthAt(right);
      leastAt = Math.min(leastAt, Math.min(atLeft, atRight));
      if (atLeft <= atRight) {
        to = right;
      } else {
        from = left;
      }
    }
    return Math.min(0, leastAt);
  }

  private double depthAt(double share) {
    return distance.toPoint(
        ends[0] + share * along[0], ends[1] + share * along[1], ends[2] + share * along[2], unused);
  }

  private void visit(int node) {
    int other = tree.second[node];
    if (other == 0) {
      for (int i = tree.first[node]; i < tree.first[node] + tree.count[node]; i++) {
        leastM = Math.min(leastM, fromTriangle(9 * i));
      }
      return;
    }
    double oneM = boundM(node + 1);
    double otherM = boundM(other);
    boolean inOrder = oneM <= otherM;
    if (Math.min(oneM, otherM) < leastM) {
      visit(inOrder ? node + 1 : other);
    }
    if (Math.max(oneM, otherM) < leastM) {
      visit(inOrder ? other : node + 1);
    }
  }

  /** No triangle of a node is nearer than this: a ball around its box, or the boxes of both. */
  private double boundM(int node) {
    int at = MeshTree.BOX * node;
    double[] box = tree.boxes;
    double half2 = 0;
    double apart2 = 0;
    for (int axis = 0; axis < 3; axis++) {
      double least = box[at + axis];
      double most = box[at + 3 + axis];
      half2 += (most - least) * (most - least) / 4;
      double low = Math.min(ends[axis], ends[3 + axis]);
      double high = Math.max(ends[axis], ends[3 + axis]);
      double gap = Math.max(0, Math.max(least - high, low - most));
      apart2 += gap * gap;
    }
    double middle =
        SegmentDistance.toPoint(
            ends[0],
            ends[1],
            ends[2],
            ends[3],
            ends[4],
            ends[5],
            (box[at] + box[at + 3]) / 2,
            (box[at + 1] + box[at + 4]) / 2,
            (box[at + 2] + box[at + 5]) / 2);
    return Math.max(middle - Math.sqrt(half2), Math.sqrt(apart2));
  }

  /**
   * Lines are nearest to a triangle at one of their ends, at one of its edges, or go through it.
   */
  private double fromTriangle(int at) {
    double share = through(at);
    if (share >= 0 && share <= 1) {
      return 0;
    }
    double least = Math.min(fromEnd(at, 0), fromEnd(at, 3));
    for (int corner = 0; corner < 3; corner++) {
      System.arraycopy(tree.corners, at + 3 * corner, edge, 0, 3);
      System.arraycopy(tree.corners, at + 3 * ((corner + 1) % 3), edge, 3, 3);
      least = Math.min(least, SegmentDistance.apart(ends, 0, edge, 0));
    }
    return least;
  }

  private double fromEnd(int at, int end) {
    nearest.find(tree.corners, at, ends[end], ends[end + 1], ends[end + 2]);
    double dx = nearest.x - ends[end];
    double dy = nearest.y - ends[end + 1];
    double dz = nearest.z - ends[end + 2];
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  private void shoot(int node) {
    if (!enters(node)) {
      return;
    }
    if (tree.second[node] != 0) {
      shoot(node + 1);
      shoot(tree.second[node]);
      return;
    }
    for (int i = tree.first[node]; i < tree.first[node] + tree.count[node]; i++) {
      double share = through(9 * i);
      if (share >= 0) {
        leastM = Math.min(leastM, share);
      }
    }
  }

  private boolean enters(int node) {
    int at = MeshTree.BOX * node;
    double from = 0;
    double to = leastM;
    for (int axis = 0; axis < 3; axis++) {
      double one = (tree.boxes[at + axis] - ends[axis]) / along[axis];
      double other = (tree.boxes[at + 3 + axis] - ends[axis]) / along[axis];
      if (along[axis] == 0) {
        if (ends[axis] < tree.boxes[at + axis] || ends[axis] > tree.boxes[at + 3 + axis]) {
          return false;
        }
      } else {
        from = Math.max(from, Math.min(one, other));
        to = Math.min(to, Math.max(one, other));
      }
    }
    return from <= to;
  }

  /**
   * The share of the line at which it goes through a triangle; NaN where it passes by. (T. Moeller,
   * B. Trumbore: "Fast, Minimum Storage Ray-Triangle Intersection", 1997.)
   */
  private double through(int at) {
    double[] c = tree.corners;
    double e1x = c[at + 3] - c[at];
    double e1y = c[at + 4] - c[at + 1];
    double e1z = c[at + 5] - c[at + 2];
    double e2x = c[at + 6] - c[at];
    double e2y = c[at + 7] - c[at + 1];
    double e2z = c[at + 8] - c[at + 2];
    double px = along[1] * e2z - along[2] * e2y;
    double py = along[2] * e2x - along[0] * e2z;
    double pz = along[0] * e2y - along[1] * e2x;
    double volume = e1x * px + e1y * py + e1z * pz;
    if (volume == 0) {
      return Double.NaN;
    }
    double tx = ends[0] - c[at];
    double ty = ends[1] - c[at + 1];
    double tz = ends[2] - c[at + 2];
    double u = (tx * px + ty * py + tz * pz) / volume;
    double qx = ty * e1z - tz * e1y;
    double qy = tz * e1x - tx * e1z;
    double qz = tx * e1y - ty * e1x;
    double v = (along[0] * qx + along[1] * qy + along[2] * qz) / volume;
    return u < 0 || v < 0 || u + v > 1 ? Double.NaN : (e2x * qx + e2y * qy + e2z * qz) / volume;
  }
}
