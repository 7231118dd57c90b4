package org.pendant.desktop.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.List;
import org.lwjgl.system.MemoryUtil;
import org.pendant.desktop.scene.mesh.Mesh;

/**
 * GPU mesh: meshes in the memory of the graphics, drawn by one call. The number of each in the list
 * is the place that moves it.
 */
final class GpuMesh implements AutoCloseable {
  private static final int FLOATS = Mesh.STRIDE * Float.BYTES;

  /** Position, normal; then place, finish and a colour. */
  private static final int STRIDE_BYTES = FLOATS + 4;

  private final int array;
  private final int vertexBuffer;
  private final int indexBuffer;
  private final int count;

  GpuMesh(List<Mesh> meshes) {
    int vertices = meshes.stream().mapToInt(Mesh::vertexCount).sum();
    count = 3 * meshes.stream().mapToInt(Mesh::triangleCount).sum();
    array = glGenVertexArrays();
    glBindVertexArray(array);
    vertexBuffer = glGenBuffers();
    indexBuffer = glGenBuffers();
    ByteBuffer vertexBytes = MemoryUtil.memAlloc(Math.max(1, vertices) * STRIDE_BYTES);
    IntBuffer corners = MemoryUtil.memAllocInt(Math.max(1, count));
    try {
      fill(meshes, vertexBytes, corners);
      glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer);
      glBufferData(GL_ARRAY_BUFFER, vertexBytes, GL_STATIC_DRAW);
      glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indexBuffer);
      glBufferData(GL_ELEMENT_ARRAY_BUFFER, corners, GL_STATIC_DRAW);
    } finally {
      MemoryUtil.memFree(vertexBytes);
      MemoryUtil.memFree(corners);
    }
    glVertexAttribPointer(0, 3, GL_FLOAT, false, STRIDE_BYTES, 0);
    glVertexAttribPointer(1, 3, GL_FLOAT, false, STRIDE_BYTES, 3 * Float.BYTES);
    glVertexAttribIPointer(2, 2, GL_UNSIGNED_BYTE, STRIDE_BYTES, FLOATS);
    glVertexAttribIPointer(3, 1, GL_UNSIGNED_SHORT, STRIDE_BYTES, FLOATS + 2);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glEnableVertexAttribArray(2);
    glEnableVertexAttribArray(3);
  }

  private static void fill(List<Mesh> meshes, ByteBuffer vertices, IntBuffer corners) {
    int first = 0;
    for (int place = 0; place < meshes.size(); place++) {
      Mesh mesh = meshes.get(place);
      for (int i = 0; i < mesh.vertexCount(); i++) {
        for (int k = 0; k < Mesh.STRIDE; k++) {
          vertices.putFloat(mesh.number(i, k));
        }
        vertices.put((byte) place).put((byte) mesh.finish(i)).putShort(colour(mesh.rgb(i)));
      }
      for (int corner : mesh.corners()) {
        corners.put(first + corner);
      }
      first += mesh.vertexCount();
    }
    vertices.flip();
    corners.flip();
  }

  /** Five bits each of red, green and blue, and above them one that says that there is a colour. */
  private static short colour(int rgb) {
    return rgb < 0
        ? 0
        : (short) (0x8000 | (rgb >> 9 & 0x7C00) | (rgb >> 6 & 0x3E0) | (rgb >> 3 & 0x1F));
  }

  void draw() {
    if (count > 0) {
      glBindVertexArray(array);
      glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, 0);
    }
  }

  @Override
  public void close() {
    glDeleteVertexArrays(array);
    glDeleteBuffers(vertexBuffer);
    glDeleteBuffers(indexBuffer);
  }
}
