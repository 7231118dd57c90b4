package org.pendant.desktop.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

import org.pendant.desktop.scene.SpeedColours;
import org.pendant.desktop.scene.TcpTrace;
import org.pendant.desktop.scene.mesh.Lines;

/** Line list: lines in the memory of the graphics: every two points in a row make a piece. */
final class LineStrip implements AutoCloseable {
  private static final double ELBOW_OPACITY = 0.7;
  private static final int STRIDE_BYTES = Lines.STRIDE * Float.BYTES;
  private static final int CORNERS = 4;

  private final int array = glGenVertexArrays();
  private final int buffer = glGenBuffers();
  private int points;

  LineStrip() {
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    attribute(0, 0);
    attribute(1, STRIDE_BYTES);
    attribute(2, 4 * Float.BYTES);
    attribute(3, STRIDE_BYTES + 4 * Float.BYTES);
  }

  private static void attribute(int index, int offset) {
    glVertexAttribPointer(index, 4, GL_FLOAT, false, STRIDE_BYTES, offset);
    glVertexAttribDivisor(index, 1);
    glEnableVertexAttribArray(index);
  }

  /** Takes other lines. */
  void load(Lines lines) {
    points = lines.size();
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, lines.numbers(), GL_DYNAMIC_DRAW);
  }

  /** The lines of a trace; that of the elbow first, so that the tool's is drawn above it. */
  static Lines lines(TcpTrace trace) {
    Lines lines = new Lines();
    trace.elbow().ifPresent(elbow -> add(lines, elbow, ELBOW_OPACITY));
    add(lines, trace, 1);
    return lines;
  }

  private static void add(Lines lines, TcpTrace trace, double most) {
    for (int i = 0; i < trace.size(); i++) {
      int rgb = SpeedColours.rgb(trace.colourShare(i));
      if (trace.begins(i)) {
        lines.from(trace.x(i), trace.y(i), trace.z(i), rgb, most * trace.opacity(i));
      } else {
        lines.to(trace.x(i), trace.y(i), trace.z(i), rgb, most * trace.opacity(i));
      }
    }
  }

  void draw() {
    if (points > 1) {
      glBindVertexArray(array);
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, CORNERS, points - 1);
    }
  }

  @Override
  public void close() {
    glDeleteVertexArrays(array);
    glDeleteBuffers(buffer);
  }
}
