package org.pendant.models.mesh;

/**
 * Mesh points: finds the points of a mesh that are in a box along its own axes. Allocates nothing
 * after it was made; for one thread at a time.
 */
public final class MeshPoints {
  private final MeshTree tree;
  private final double[] least = new double[3];
  private final double[] most = new double[3];

  /** Takes a point of a mesh. */
  @FunctionalInterface
  public interface Taker {
    /** Takes its coordinates, m. */
    void take(double x, double y, double z);
  }

  /** The points of a mesh. */
  public MeshPoints(TriangleMesh mesh) {
    tree = mesh.tree();
  }

  /**
   * Tells those that are as near as that to a place along each axis, each once, in a fixed order.
   */
  public void near(double x, double y, double z, double withinM, Taker taker) {
    least[0] = x - withinM;
    least[1] = y - withinM;
    least[2] = z - withinM;
    for (int axis = 0; axis < 3; axis++) {
      most[axis] = least[axis] + 2 * withinM;
    }
    visit(0, taker);
  }

  private void visit(int node, Taker taker) {
    int at = MeshTree.BOX * node;
    for (int axis = 0; axis < 3; axis++) {
      if (tree.boxes[at + axis] > most[axis] || tree.boxes[at + 3 + axis] < least[axis]) {
        return;
      }
    }
    if (tree.second[node] != 0) {
      visit(node + 1, taker);
      visit(tree.second[node], taker);
      return;
    }
    for (int i = 3 * tree.first[node]; i < 3 * (tree.first[node] + tree.count[node]); i++) {
      if (tree.owned[i] && holds(3 * i)) {
        taker.take(tree.corners[3 * i], tree.corners[3 * i + 1], tree.corners[3 * i + 2]);
      }
    }
  }

  private boolean holds(int at) {
    for (int axis = 0; axis < 3; axis++) {
      double coordinate = tree.corners[at + axis];
      if (coordinate < least[axis] || coordinate > most[axis]) {
        return false;
      }
    }
    return true;
  }
}
