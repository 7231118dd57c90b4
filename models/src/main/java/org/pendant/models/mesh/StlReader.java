package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * STL reader: reads files of triangles, binary ones and those that are text. What they say of
 * normals is not used: the order of corners tells the same, and both often differ.
 */
final class StlReader {
  private static final int HEADER = 84;
  private static final int TRIANGLE = 50;
  private static final String WORD = "solid";

  private StlReader() {}

  static void read(byte[] bytes, MeshAssembly into) throws MeshException {
    // a binary file may begin as a text does, so its length has to tell
    boolean text =
        bytes.length >= WORD.length()
            && new String(bytes, 0, WORD.length(), StandardCharsets.ISO_8859_1).equals(WORD)
            && !fits(bytes);
    if (text && !hasZero(bytes)) {
      readText(new MeshLines(bytes), into);
    } else {
      readBinary(bytes, into);
    }
  }

  private static boolean fits(byte[] bytes) {
    return bytes.length >= HEADER && bytes.length == HEADER + TRIANGLE * count(bytes);
  }

  private static long count(byte[] bytes) {
    return Integer.toUnsignedLong(
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt(HEADER - Integer.BYTES));
  }

  private static boolean hasZero(byte[] bytes) {
    for (byte each : bytes) {
      if (each == 0) {
        return true;
      }
    }
    return false;
  }

  private static void readBinary(byte[] bytes, MeshAssembly into) throws MeshException {
    if (bytes.length < HEADER) {
      throw new MeshException(text("stlHeaderCut", bytes.length, HEADER));
    }
    long count = count(bytes);
    if (!fits(bytes)) {
      throw new MeshException(
          text(
              bytes.length < HEADER + TRIANGLE * count ? "stlTrianglesCut" : "noStl",
              text("stlTriangles", bytes.length, count, HEADER + TRIANGLE * count)));
    }
    if (count > TriangleMesh.MAX_TRIANGLES) {
      throw new MeshException(MeshAssembly.tooMany(String.valueOf(count)));
    }
    ByteBuffer from = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int[] corners = new int[3];
    for (int triangle = 0; triangle < count; triangle++) {
      from.position(HEADER + TRIANGLE * triangle + 3 * Float.BYTES);
      int number = triangle + 1;
      for (int i = 0; i < corners.length; i++) {
        corners[i] =
            into.point(
                () -> text("triangle", number), from.getFloat(), from.getFloat(), from.getFloat());
      }
      into.triangle(corners[0], corners[1], corners[2]);
    }
  }

  private static void readText(MeshLines lines, MeshAssembly into) throws MeshException {
    int[] corners = new int[3];
    while (lines.next()) {
      lines.require(WORD);
      require(lines);
      while (lines.is("facet")) {
        require(lines);
        lines.require("outer");
        for (int i = 0; i < corners.length; i++) {
          require(lines);
          lines.require("vertex");
          corners[i] = into.point(lines::where, lines.number(1), lines.number(2), lines.number(3));
        }
        into.triangle(corners[0], corners[1], corners[2]);
        require(lines);
        lines.require("endloop");
        require(lines);
        lines.require("endfacet");
        require(lines);
      }
      lines.require("endsolid");
    }
  }

  private static void require(MeshLines lines) throws MeshException {
    if (!lines.next()) {
      throw new MeshException(text("stlCut"));
    }
  }
}
