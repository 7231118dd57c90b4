package org.pendant.desktop.scene.mesh;

import java.util.Arrays;
import org.joml.Vector3f;

/**
 * Mesh: triangles of closed surfaces, in m, each with its corners counter-clockwise as seen from
 * outside. Immutable; a mesh of several parts is closed part by part.
 */
public final class Mesh {
  /** Numbers of a vertex: position, m, then the outward normal of length 1. */
  public static final int STRIDE = 6;

  private final float[] vertices;
  private final byte[] finishes;
  private final int[] colours;
  private final int[] corners;

  Mesh(float[] vertices, byte[] finishes, int[] colours, int[] corners) {
    this.vertices = vertices;
    this.finishes = finishes;
    this.colours = colours;
    this.corners = corners;
  }

  /** How many vertices there are. */
  public int vertexCount() {
    return finishes.length;
  }

  /** How many triangles there are. */
  public int triangleCount() {
    return corners.length / 3;
  }

  /** Number {@code k} of vertex {@code i}: 0 to 2 of its position, m, 3 to 5 of its normal. */
  public float number(int i, int k) {
    return vertices[STRIDE * i + k];
  }

  /** Position of vertex {@code i}, m. */
  public Vector3f position(int i) {
    return new Vector3f(number(i, 0), number(i, 1), number(i, 2));
  }

  /** Outward normal at vertex {@code i}. */
  public Vector3f normal(int i) {
    return new Vector3f(number(i, 3), number(i, 4), number(i, 5));
  }

  /** {@link Finish#number} of what the surface looks like at vertex {@code i}. */
  public int finish(int i) {
    return finishes[i];
  }

  /**
   * The colour of the surface at vertex {@code i} in place of that of its finish, as screens have
   * it; below 0 for none.
   */
  public int rgb(int i) {
    return colours[i];
  }

  /** The vertex at corner {@code k}, 0 to 2, of triangle {@code t}. */
  public int corner(int t, int k) {
    return corners[3 * t + k];
  }

  /** All corners, three to a triangle, in a new array. */
  public int[] corners() {
    return Arrays.copyOf(corners, corners.length);
  }

  /** The box along the axes that just holds the mesh; of no vertices, one turned inside out. */
  public Box box() {
    Vector3f low = new Vector3f(Float.POSITIVE_INFINITY);
    Vector3f high = new Vector3f(Float.NEGATIVE_INFINITY);
    for (int i = 0; i < vertexCount(); i++) {
      low.min(position(i));
      high.max(position(i));
    }
    return new Box(low.x, low.y, low.z, high.x, high.y, high.z);
  }

  /** A box along the axes, from its low corner to its high one, m. */
  public record Box(float lowX, float lowY, float lowZ, float highX, float highY, float highZ) {}
}
