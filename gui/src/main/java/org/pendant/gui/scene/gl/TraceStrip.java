package org.pendant.gui.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

import java.nio.FloatBuffer;
import org.lwjgl.system.MemoryUtil;
import org.pendant.gui.scene.SpeedColours;
import org.pendant.gui.scene.Trace;

/** A trace in the memory of the graphics: every two points in a row make a piece. */
final class TraceStrip implements AutoCloseable {
  /** Position, whether a line begins here, colour. */
  private static final int FLOATS = 7;

  private static final int STRIDE_BYTES = FLOATS * Float.BYTES;
  private static final int CORNERS = 4;

  private final int array = glGenVertexArrays();
  private final int buffer = glGenBuffers();
  private Trace loaded = Trace.EMPTY;

  TraceStrip() {
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    attribute(0, 4, 0);
    attribute(1, 4, STRIDE_BYTES);
    attribute(2, 3, 4 * Float.BYTES);
    attribute(3, 3, STRIDE_BYTES + 4 * Float.BYTES);
  }

  private static void attribute(int index, int size, int offset) {
    glVertexAttribPointer(index, size, GL_FLOAT, false, STRIDE_BYTES, offset);
    glVertexAttribDivisor(index, 1);
    glEnableVertexAttribArray(index);
  }

  /** Takes another trace, if it is another. */
  void load(Trace trace) {
    if (trace == loaded) {
      return;
    }
    loaded = trace;
    FloatBuffer floats = MemoryUtil.memAllocFloat(Math.max(1, FLOATS * trace.size()));
    try {
      for (int i = 0; i < trace.size(); i++) {
        floats.put(trace.x(i)).put(trace.y(i)).put(trace.z(i)).put(trace.begins(i) ? 1 : 0);
        int rgb = SpeedColours.rgb(trace.speedShare(i));
        floats.put((rgb >> 16 & 0xFF) / 255f).put((rgb >> 8 & 0xFF) / 255f);
        floats.put((rgb & 0xFF) / 255f);
      }
      glBindBuffer(GL_ARRAY_BUFFER, buffer);
      glBufferData(GL_ARRAY_BUFFER, floats.flip(), GL_DYNAMIC_DRAW);
    } finally {
      MemoryUtil.memFree(floats);
    }
  }

  void draw() {
    if (loaded.size() > 1) {
      glBindVertexArray(array);
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, CORNERS, loaded.size() - 1);
    }
  }

  @Override
  public void close() {
    glDeleteVertexArrays(array);
    glDeleteBuffers(buffer);
  }
}
