package org.pendant.desktop.scene.mesh;

import java.util.Arrays;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;

/**
 * Mesh builder: gathers the vertices and triangles of a mesh, part by part, each part in a place of
 * its own.
 */
final class MeshBuilder {
  /** For surfaces that have the colour of their finish. */
  static final int NO_COLOUR = -1;

  private float[] vertices = new float[Mesh.STRIDE * 1024];
  private byte[] finishes = new byte[1024];
  private int[] colours = new int[1024];
  private int[] corners = new int[4096];
  private int vertexCount;
  private int cornerCount;
  private final Matrix4f place = new Matrix4f();
  private final Vector3f scratch = new Vector3f();
  private final Detail detail;
  private byte finish;
  private int rgb = NO_COLOUR;

  /**
   * @param detail how finely the parts that follow are cut
   */
  MeshBuilder(Detail detail) {
    this.detail = detail;
  }

  Detail detail() {
    return detail;
  }

  /**
   * Where the parts that follow go.
   *
   * @param frame the frame they are described in, seen from the mesh's: no scaling
   */
  MeshBuilder at(Matrix4fc frame) {
    place.set(frame);
    return this;
  }

  /** What the parts that follow look like. */
  MeshBuilder finish(Finish next) {
    finish = (byte) next.number();
    rgb = NO_COLOUR;
    return this;
  }

  /** The colour of the vertices that follow in place of that of their finish. */
  MeshBuilder colour(int next) {
    rgb = next;
    return this;
  }

  /** Adds a vertex in the frame of the part, and answers its number. */
  int vertex(float x, float y, float z, float nx, float ny, float nz) {
    if (vertexCount == finishes.length) {
      finishes = Arrays.copyOf(finishes, 2 * vertexCount);
      colours = Arrays.copyOf(colours, 2 * vertexCount);
      vertices = Arrays.copyOf(vertices, 2 * vertices.length);
    }
    place.transformPosition(x, y, z, scratch);
    int at = Mesh.STRIDE * vertexCount;
    vertices[at] = scratch.x;
    vertices[at + 1] = scratch.y;
    vertices[at + 2] = scratch.z;
    place.transformDirection(nx, ny, nz, scratch).normalize();
    vertices[at + 3] = scratch.x;
    vertices[at + 4] = scratch.y;
    vertices[at + 5] = scratch.z;
    finishes[vertexCount] = finish;
    colours[vertexCount] = rgb;
    return vertexCount++;
  }

  /** Adds a triangle, counter-clockwise from outside; one without an area is left out. */
  void triangle(int a, int b, int c) {
    if (same(a, b) || same(b, c) || same(c, a)) {
      return;
    }
    if (cornerCount + 3 > corners.length) {
      corners = Arrays.copyOf(corners, 2 * corners.length);
    }
    corners[cornerCount++] = a;
    corners[cornerCount++] = b;
    corners[cornerCount++] = c;
  }

  /**
   * Joins rings of vertices to a skin.
   *
   * @param first number of the first vertex; ring after ring from there on
   * @param rings how many rings
   * @param around vertices of a ring, counter-clockwise as seen from the last ring
   */
  void skin(int first, int rings, int around) {
    for (int ring = 0; ring + 1 < rings; ring++) {
      for (int j = 0; j < around; j++) {
        int a = first + ring * around + j;
        int b = first + ring * around + (j + 1) % around;
        triangle(a, b, b + around);
        triangle(a, b + around, a + around);
      }
    }
  }

  private boolean same(int a, int b) {
    int at = Mesh.STRIDE * a;
    int other = Mesh.STRIDE * b;
    return vertices[at] == vertices[other]
        && vertices[at + 1] == vertices[other + 1]
        && vertices[at + 2] == vertices[other + 2];
  }

  Mesh build() {
    return new Mesh(
        Arrays.copyOf(vertices, Mesh.STRIDE * vertexCount),
        Arrays.copyOf(finishes, vertexCount),
        Arrays.copyOf(colours, vertexCount),
        Arrays.copyOf(corners, cornerCount));
  }
}
