package org.pendant.desktop.scene.mesh;

import org.joml.Vector3f;

/**
 * Block: a box with bevelled edges around the origin of its frame. Each corner has three vertices,
 * one for each face; the bevels between are shaded as if they were round.
 */
final class Block {
  private static final int CORNERS = 8;

  private final Vector3f half;
  private final float bevelM;

  /**
   * @param half half the lengths of its sides, m
   * @param bevelM width of the bevels, m, less than half of the shortest side
   */
  Block(Vector3f half, double bevelM) {
    this.half = half;
    this.bevelM = (float) bevelM;
  }

  void addTo(MeshBuilder mesh) {
    int first = -1;
    for (int axis = 0; axis < 3; axis++) {
      for (int corner = 0; corner < CORNERS; corner++) {
        Vector3f p = point(axis, corner);
        Vector3f n = new Vector3f().setComponent(axis, sign(corner, axis));
        int vertex = mesh.vertex(p.x, p.y, p.z, n.x, n.y, n.z);
        first = first < 0 ? vertex : first;
      }
    }
    for (int axis = 0; axis < 3; axis++) {
      int b = 1 << (axis + 1) % 3;
      int c = 1 << (axis + 2) % 3;
      addFace(mesh, first, axis, 0, b, c);
      addFace(mesh, first, axis, 1 << axis, b, c);
      addEdges(mesh, first, axis, (axis + 1) % 3);
    }
    for (int corner = 0; corner < CORNERS; corner++) {
      add(mesh, first, corner, CORNERS + corner, 2 * CORNERS + corner);
    }
  }

  private void addFace(MeshBuilder mesh, int first, int axis, int at, int b, int c) {
    int start = axis * CORNERS + at;
    add(mesh, first, start, start + b, start + b + c);
    add(mesh, first, start, start + b + c, start + c);
  }

  /** The four bevels between the faces of two axes. */
  private void addEdges(MeshBuilder mesh, int first, int axis, int other) {
    int along = 1 << (3 - axis - other);
    for (int corner = 0; corner < CORNERS; corner++) {
      if ((corner & along) == 0) {
        int a = axis * CORNERS + corner;
        int b = other * CORNERS + corner;
        add(mesh, first, a, a + along, b + along);
        add(mesh, first, a, b + along, b);
      }
    }
  }

  /** Adds a triangle the way round that faces away from the middle. */
  private void add(MeshBuilder mesh, int first, int a, int b, int c) {
    Vector3f pa = point(a / CORNERS, a % CORNERS);
    Vector3f ab = point(b / CORNERS, b % CORNERS).sub(pa);
    Vector3f ac = point(c / CORNERS, c % CORNERS).sub(pa);
    if (ab.cross(ac).dot(pa) > 0) {
      mesh.triangle(first + a, first + b, first + c);
    } else {
      mesh.triangle(first + a, first + c, first + b);
    }
  }

  private Vector3f point(int axis, int corner) {
    Vector3f point = new Vector3f();
    for (int i = 0; i < 3; i++) {
      float inset = i == axis ? 0 : bevelM;
      point.setComponent(i, sign(corner, i) * (half.get(i) - inset));
    }
    return point;
  }

  private static float sign(int corner, int axis) {
    return (corner >> axis & 1) == 0 ? -1 : 1;
  }
}
