package org.pendant.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.ode4j.ode.DContactGeomBuffer;
import org.pendant.models.mesh.ConvexHull;
import org.pendant.models.mesh.MeshException;
import org.pendant.models.pose.Pose;

/** Hulls touch along the direction in which they overlap least, of all that there are. */
class HullDirectionTest {
  private static final int PAIRS = 1000;

  /** Nearer to touching than that either answer is right, m. */
  private static final double TOUCH_M = 2e-5;

  /** Bodies do not get deeper into one another than that, m. */
  private static final double DEEP_M = 5e-3;

  /** An overlap may be larger than the least by that share. */
  private static final double SHARE = 0.2;

  @Test
  void theDirectionIsTheBestOfAllFacesAndEdges() throws MeshException {
    Random random = new Random(7);
    HullContacts contacts = new HullContacts();
    DContactGeomBuffer found = NarrowPhase.buffer();
    int touching = 0;
    int across = 0;
    for (int pair = 0; pair < PAIRS; pair++) {
      BodyPart one = body(random, 0);
      BodyPart other = body(random, 0.025 + 0.025 * random.nextDouble());
      int count = contacts.find(one, other, 4, found);
      double faces = Math.max(bestOfFaces(one, other), bestOfFaces(other, one));
      double apart = Math.max(faces, bestOfEdges(one, other));
      String which = "pair " + pair + ", apart by " + apart;
      if (Math.abs(apart) > TOUCH_M) {
        assertEquals(apart < 0, count > 0, which);
      }
      if (count > 0 && apart < 0 && apart > -DEEP_M) {
        double[] n = found.get(0).normal.toDoubleArray();
        double overlap = -apart(one, other, n[0], n[1], n[2]);
        assertTrue(overlap <= (1 + SHARE) * -apart + TOUCH_M, which + ", overlap " + overlap);
        touching++;
        across += apart > faces + TOUCH_M ? 1 : 0;
      }
    }
    assertTrue(touching > PAIRS / 10, touching + " touch");
    assertTrue(across > PAIRS / 50, across + " touch across edges");
  }

  private static BodyPart body(Random random, double x) throws MeshException {
    double[] points = new double[30];
    for (int i = 0; i < 15; i++) {
      points[i] = 0.06 * (random.nextDouble() - 0.5);
      points[15 + i] = -0.8 * points[i];
    }
    Pose pose =
        new Pose(
            x,
            0.01 * random.nextGaussian(),
            0.01 * random.nextGaussian(),
            random.nextGaussian(),
            random.nextGaussian(),
            random.nextGaussian());
    BodyPart body =
        new CellBody(
                BodyDescription.free(
                    "hull",
                    new BodyShape.Hull(ConvexHull.of(points), 1e-4, 1e-4, 1e-4),
                    pose,
                    1,
                    BodySurface.DEFAULT),
                0)
            .parts[0];
    body.solid().follow();
    return body;
  }

  /** How far the first is from the second along a direction out of that, of length 1, m. */
  private static double apart(BodyPart one, BodyPart other, double x, double y, double z) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < one.solid().points.length; i += 3) {
      double[] p = one.solid().points;
      least = Math.min(least, x * p[i] + y * p[i + 1] + z * p[i + 2]);
    }
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < other.solid().points.length; i += 3) {
      double[] p = other.solid().points;
      most = Math.max(most, x * p[i] + y * p[i + 1] + z * p[i + 2]);
    }
    return least - most;
  }

  private static double bestOfFaces(BodyPart of, BodyPart other) {
    double best = Double.NEGATIVE_INFINITY;
    double[] p = of.solid().planes;
    for (int i = 0; i < p.length; i += 4) {
      best = Math.max(best, apart(other, of, p[i], p[i + 1], p[i + 2]));
    }
    return best;
  }

  private static double bestOfEdges(BodyPart one, BodyPart other) {
    double best = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < one.solid().edges.length; i += 4) {
      double[] u = along(one.solid(), i);
      for (int j = 0; j < other.solid().edges.length; j += 4) {
        double[] v = along(other.solid(), j);
        double x = u[1] * v[2] - u[2] * v[1];
        double y = u[2] * v[0] - u[0] * v[2];
        double z = u[0] * v[1] - u[1] * v[0];
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length > 1e-9) {
          best = Math.max(best, apart(one, other, x / length, y / length, z / length));
          best = Math.max(best, apart(one, other, -x / length, -y / length, -z / length));
        }
      }
    }
    return best;
  }

  private static double[] along(Polyhedron solid, int edge) {
    double[] along = new double[3];
    for (int k = 0; k < 3; k++) {
      along[k] =
          solid.points[3 * solid.edges[edge + 1] + k] - solid.points[3 * solid.edges[edge] + k];
    }
    return along;
  }
}
