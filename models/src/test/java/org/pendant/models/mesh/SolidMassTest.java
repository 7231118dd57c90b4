package org.pendant.models.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Transforms;

class SolidMassTest {
  private static TriangleMesh mesh(float[][] triangles) throws MeshException {
    return MeshFile.read("a.stl", MeshTexts.binaryStl(triangles), MeshUnit.METRE);
  }

  private static float[][] shifted(float[][] triangles, float x, float y, float z) {
    float[] by = {x, y, z};
    return Arrays.stream(triangles)
        .map(
            triangle -> {
              float[] moved = triangle.clone();
              for (int i = 0; i < moved.length; i++) {
                moved[i] += by[i % 3];
              }
              return moved;
            })
        .toArray(float[][]::new);
  }

  private static float[][] both(float[][] one, float[][] other) {
    float[][] all = Arrays.copyOf(one, one.length + other.length);
    System.arraycopy(other, 0, all, one.length, other.length);
    return all;
  }

  private static void requireMoments(SolidMass mass, double x, double y, double z) {
    double[] found = {mass.momentM2(0), mass.momentM2(1), mass.momentM2(2)};
    assertArrayEquals(new double[] {x, y, z}, found, 1e-7);
  }

  @Test
  void aBlockHasItsMiddleAndTheMomentsOfTextbooks() throws MeshException {
    SolidMass mass = mesh(shifted(MeshTexts.box(0.5f, 0.25f, 0.125f), 1, -2, 3)).mass();

    assertEquals(1.25, mass.centreM(0), 1e-9);
    assertEquals(-1.875, mass.centreM(1), 1e-9);
    assertEquals(3.0625, mass.centreM(2), 1e-9);
    double x2 = 0.25;
    double y2 = 0.0625;
    double z2 = 0.015625;
    requireMoments(mass, (y2 + z2) / 12, (z2 + x2) / 12, (x2 + y2) / 12);
    double[] frame = new double[Transforms.SIZE];
    mass.principalFrame(frame);
    assertArrayEquals(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, Arrays.copyOf(frame, 9), 1e-12);
  }

  @Test
  void twoBlocksAreHeaviestBetweenThem() throws MeshException {
    // along a diagonal of the x-y plane: Steiner's share is about the axes across it
    float[][] block = MeshTexts.box(0.5f, 0.5f, 0.5f);
    SolidMass mass = mesh(both(block, shifted(block, 2, 2, 0))).mass();

    assertEquals(1.25, mass.centreM(0), 1e-9);
    assertEquals(1.25, mass.centreM(1), 1e-9);
    double own = 0.25 / 6;
    double[] moments = {mass.momentM2(0), mass.momentM2(1), mass.momentM2(2)};
    Arrays.sort(moments);
    assertArrayEquals(new double[] {own, own + 2, own + 2}, moments, 1e-7);
    double[] frame = new double[Transforms.SIZE];
    mass.principalFrame(frame);
    int along = mass.momentM2(0) < 1 ? 0 : 1;
    assertEquals(Math.sqrt(0.5), Math.abs(frame[along]), 1e-9);
    assertEquals(Math.sqrt(0.5), Math.abs(frame[3 + along]), 1e-9);
  }

  @Test
  void itIsWhatCountingSmallCubesTells() throws MeshException {
    float[][] solid = MeshTexts.bumpy(new Random(8), 5, 6, 2);
    TriangleMesh mesh = mesh(solid);
    MeshDistance distance = new MeshDistance(mesh);
    double[] sum = new double[3];
    double[] second = new double[9];
    int count = 0;
    double step = 0.125;
    for (double x = -2; x < 2; x += step) {
      for (double y = -2; y < 2; y += step) {
        for (double z = -2; z < 2; z += step) {
          if (distance.toPoint(x, y, z, new double[3]) < 0) {
            double[] at = {x, y, z};
            count++;
            for (int i = 0; i < 9; i++) {
              sum[i % 3] += i < 3 ? at[i] : 0;
              second[i] += at[i / 3] * at[i % 3];
            }
          }
        }
      }
    }
    SolidMass mass = mesh.mass();
    double[] frame = new double[Transforms.SIZE];
    mass.principalFrame(frame);
    double spread = 0;
    for (int axis = 0; axis < 3; axis++) {
      assertEquals(sum[axis] / count, mass.centreM(axis), 0.01);
      spread += (mass.momentM2(0) + mass.momentM2(1) + mass.momentM2(2)) / 6;
    }
    for (int i = 0; i < 9; i++) {
      double found = 0;
      for (int axis = 0; axis < 3; axis++) {
        double square = (mass.momentM2(0) + mass.momentM2(1) + mass.momentM2(2)) / 2;
        found +=
            (square - mass.momentM2(axis)) * frame[3 * (i / 3) + axis] * frame[3 * (i % 3) + axis];
      }
      double counted = second[i] / count - mass.centreM(i / 3) * mass.centreM(i % 3);
      assertEquals(counted, found, 0.02 * spread, "second moment " + i);
    }
  }

  @Test
  void solidsWithPartsThatCountAsLessThanNothingAreRefused() throws MeshException {
    // a small cube, and two that are inside out far away
    float[][] cube = MeshTexts.box(1, 1, 1);
    float[][] hole = MeshTexts.box(0.75f, 0.75f, 0.75f);
    for (float[] t : hole) {
      for (int i = 3; i < 6; i++) {
        float swapped = t[i];
        t[i] = t[i + 3];
        t[i + 3] = swapped;
      }
    }
    TriangleMesh mesh = mesh(both(cube, both(shifted(hole, 4, 0, 0), shifted(hole, -4, 0, 0))));

    assertEquals(
        "goes through itself so that parts of it count as less than nothing, must be the surface"
            + " of a solid to have a mass",
        assertThrows(MeshException.class, mesh::mass).getMessage());
  }
}
