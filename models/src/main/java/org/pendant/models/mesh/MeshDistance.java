package org.pendant.models.mesh;

/**
 * Mesh distance: how far places are from the surface of a mesh, along its own axes. Allocates
 * nothing after it was made; for one thread at a time.
 */
public final class MeshDistance {
  /** Nearer than this a place is on the surface, m. */
  private static final double ON_M = 1e-12;

  private final MeshTree tree;
  private final TrianglePoint nearest = new TrianglePoint();
  private double x;
  private double y;
  private double z;
  private double least2;
  private double leastX;
  private double leastY;
  private double leastZ;
  private int normalAt;

  /** Distances from a mesh. */
  public MeshDistance(TriangleMesh mesh) {
    tree = mesh.tree();
  }

  /**
   * How far a point is away, m: below 0 by the depth inside.
   *
   * @param normal3 overwritten with the direction, of length 1, in which the distance grows fastest
   */
  public double toPoint(double px, double py, double pz, double[] normal3) {
    x = px;
    y = py;
    z = pz;
    least2 = Double.POSITIVE_INFINITY;
    visit(0);
    double[] normals = tree.normals;
    double dx = x - leastX;
    double dy = y - leastY;
    double dz = z - leastZ;
    double side = dx * normals[normalAt] + dy * normals[normalAt + 1] + dz * normals[normalAt + 2];
    double distance = Math.sqrt(least2);
    double sign = side < 0 ? -1 : 1;
    if (distance < ON_M) {
      dx = normals[normalAt];
      dy = normals[normalAt + 1];
      dz = normals[normalAt + 2];
      sign = 1;
    }
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    boolean known = length > 0;
    normal3[0] = known ? sign * dx / length : 0;
    normal3[1] = known ? sign * dy / length : 0;
    normal3[2] = known ? sign * dz / length : 1;
    return sign * distance;
  }

  private void visit(int node) {
    int other = tree.second[node];
    if (other == 0) {
      for (int i = tree.first[node]; i < tree.first[node] + tree.count[node]; i++) {
        look(i);
      }
      return;
    }
    double one2 = square(node + 1);
    double other2 = square(other);
    boolean inOrder = one2 <= other2;
    if (Math.min(one2, other2) < least2) {
      visit(inOrder ? node + 1 : other);
    }
    if (Math.max(one2, other2) < least2) {
      visit(inOrder ? other : node + 1);
    }
  }

  /** How far the point is from a box, squared. */
  private double square(int node) {
    int at = MeshTree.BOX * node;
    double[] box = tree.boxes;
    double dx = Math.max(0, Math.max(box[at] - x, x - box[at + 3]));
    double dy = Math.max(0, Math.max(box[at + 1] - y, y - box[at + 4]));
    double dz = Math.max(0, Math.max(box[at + 2] - z, z - box[at + 5]));
    return dx * dx + dy * dy + dz * dz;
  }

  private void look(int triangle) {
    nearest.find(tree.corners, 9 * triangle, x, y, z);
    double dx = x - nearest.x;
    double dy = y - nearest.y;
    double dz = z - nearest.z;
    double square = dx * dx + dy * dy + dz * dz;
    int at = MeshTree.NORMALS * triangle + 3 * nearest.part;
    // of thin triangles only what they share with others tells a direction
    if (square < least2 || (square == least2 && !directed(normalAt) && directed(at))) {
      least2 = square;
      leastX = nearest.x;
      leastY = nearest.y;
      leastZ = nearest.z;
      normalAt = at;
    }
  }

  private boolean directed(int at) {
    double[] normals = tree.normals;
    return normals[at] != 0 || normals[at + 1] != 0 || normals[at + 2] != 0;
  }
}
