package org.pendant.models.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Random;

/** Mesh texts: solids for tests, and files of them. */
final class MeshTexts {
  private MeshTexts() {}

  /** A closed surface around the origin, some bumps on a ball, with about so many triangles. */
  static float[][] bumpy(Random random, int rings, int around, float radius) {
    float[][][] grid = new float[rings + 1][around][];
    for (int ring = 0; ring <= rings; ring++) {
      boolean pole = ring == 0 || ring == rings;
      for (int j = 0; j < around; j++) {
        double bump = radius * (0.8 + 0.2 * random.nextDouble());
        double polar = Math.PI * ring / rings;
        double turn = 2 * Math.PI * j / around;
        grid[ring][j] =
            pole && j > 0
                ? grid[ring][0]
                : new float[] {
                  pole ? 0 : shortened(bump * Math.sin(polar) * Math.cos(turn)),
                  pole ? 0 : shortened(bump * Math.sin(polar) * Math.sin(turn)),
                  shortened(bump * Math.cos(polar))
                };
      }
    }
    float[][] triangles = new float[2 * around * (rings - 1)][];
    int count = 0;
    for (int ring = 0; ring < rings; ring++) {
      for (int j = 0; j < around; j++) {
        float[] a = grid[ring][j];
        float[] b = grid[ring + 1][j];
        float[] c = grid[ring + 1][(j + 1) % around];
        float[] d = grid[ring][(j + 1) % around];
        if (ring < rings - 1) {
          triangles[count++] = triangle(a, b, c);
        }
        if (ring > 0) {
          triangles[count++] = triangle(a, c, d);
        }
      }
    }
    return triangles;
  }

  /** A number that a text has as exactly as a binary file. */
  private static float shortened(double number) {
    return Math.round(number * 8) / 8f;
  }

  /** The twelve triangles of a box that has a corner in the origin. */
  static float[][] box(float x, float y, float z) {
    float[][] corners = new float[8][];
    for (int i = 0; i < 8; i++) {
      corners[i] = new float[] {(i & 1) * x, (i >> 1 & 1) * y, (i >> 2) * z};
    }
    int[] faces = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    float[][] triangles = new float[12][];
    for (int face = 0; face < 6; face++) {
      float[] first = corners[faces[4 * face]];
      for (int half = 0; half < 2; half++) {
        triangles[2 * face + half] =
            triangle(
                first, corners[faces[4 * face + 1 + half]], corners[faces[4 * face + 2 + half]]);
      }
    }
    return triangles;
  }

  private static float[] triangle(float[] a, float[] b, float[] c) {
    return new float[] {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]};
  }

  static byte[] binaryStl(float[][] triangles) {
    ByteBuffer file =
        ByteBuffer.allocate(84 + 50 * triangles.length).order(ByteOrder.LITTLE_ENDIAN);
    file.put("solid as some programs begin".getBytes(StandardCharsets.US_ASCII)).position(80);
    file.putInt(triangles.length);
    for (float[] triangle : triangles) {
      file.putFloat(0).putFloat(0).putFloat(0);
      for (float each : triangle) {
        file.putFloat(each);
      }
      file.putShort((short) 0);
    }
    return file.array();
  }

  static byte[] textStl(float[][] triangles) {
    StringBuilder text = new StringBuilder("solid part of something\r\n");
    for (float[] t : triangles) {
      text.append("  facet normal 0 0 0\r\n    outer loop\r\n");
      for (int i = 0; i < 9; i += 3) {
        text.append(
            String.format(Locale.ROOT, "      vertex %s %s %s%n", t[i], t[i + 1], t[i + 2]));
      }
      text.append("    endloop\n  endfacet\n");
    }
    return text.append("endsolid part\n").toString().getBytes(StandardCharsets.US_ASCII);
  }

  static byte[] obj(float[][] triangles) {
    StringBuilder text = new StringBuilder("# made by hand\nmtllib none.mtl\no part\n");
    for (float[] t : triangles) {
      for (int i = 0; i < 9; i += 3) {
        text.append("v ").append(t[i]).append(' ').append(t[i + 1]).append(' ').append(t[i + 2]);
        text.append('\n');
      }
      text.append("f -3/1/1 -2//2 -1\n");
    }
    return text.toString().getBytes(StandardCharsets.US_ASCII);
  }
}
