package org.pendant.cell;

import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DContactGeomBuffer;

/**
 * Convex contacts: along which direction two convex shapes touch, and where. The direction is the
 * one in which they overlap least: out of a face of one of them mostly, else the one in which their
 * cores are nearest. Allocates nothing.
 */
final class ConvexContacts {
  /** What {@link #find} answers where shapes are so deep in one another that it cannot tell. */
  static final int UNKNOWN = -1;

  /** A direction out of a face counts though another one overlaps by so much less, and a share. */
  private static final double FACE_M = 2e-5;

  private static final double FACE_SHARE = 0.95;

  /** Faces that touch have a place in common at least that deep, as a share of the overlap. */
  private static final double DEEP_SHARE = 0.9;

  /** Steps to the nearest places of two cores. */
  private static final int MAX_STEPS = 12;

  /** A step is the last if it goes no farther, squared, m^2. */
  private static final double NEAR_M2 = 1e-16;

  /** Directions are parallel whose cross product is shorter, squared. */
  private static final double PARALLEL_2 = 1e-6;

  private final ContactManifold manifold = new ContactManifold();
  private final double[] onFirst = new double[3];
  private final double[] onSecond = new double[3];

  private ConvexShape first;
  private ConvexShape second;
  private double[] pose1;
  private double[] pose2;

  /** The direction of the least overlap so far, out of the second shape; and how much that is. */
  private double bestX;

  private double bestY;
  private double bestZ;
  private double leastM;

  /**
   * Finds where two shapes touch.
   *
   * @param other null for a half space below its own z = 0
   * @param found overwritten with the places, at most 4, their normals out of the other shape
   * @return how many there are, or {@link #UNKNOWN}
   */
  int find(
      ConvexShape one,
      double[] pose,
      ConvexShape other,
      double[] poseOther,
      DContactGeomBuffer found) {
    first = one;
    second = other;
    pose1 = pose;
    pose2 = poseOther;
    leastM = Double.POSITIVE_INFINITY;
    if (second == null) {
      return onHalfSpace(found);
    }
    if (!faces(first, pose1) || !faces(second, pose2)) {
      return 0;
    }
    if (leastM < Double.POSITIVE_INFINITY && facesMeet()) {
      return manifold.tell(found, leastM);
    }
    double faceX = bestX;
    double faceY = bestY;
    double faceZ = bestZ;
    double faceM = leastM;
    boolean apart = cores();
    if (leastM <= 0 || !edges()) {
      return 0;
    }
    if (!apart) {
      return UNKNOWN;
    }
    if (leastM > FACE_SHARE * faceM - FACE_M) {
      bestX = faceX;
      bestY = faceY;
      bestZ = faceZ;
      leastM = faceM;
    }
    meetAlongBest();
    return manifold.tell(found, leastM);
  }

  /**
   * Finds where two shapes touch along the normal of a contact that is known.
   *
   * @param found begins with that contact; overwritten
   */
  int findAlong(DContactGeom known, DContactGeomBuffer found) {
    bestX = known.normal.get0();
    bestY = known.normal.get1();
    bestZ = known.normal.get2();
    leastM = known.depth;
    meetAlongBest();
    return manifold.tell(found, leastM);
  }

  private int onHalfSpace(DContactGeomBuffer found) {
    bestX = pose2[2];
    bestY = pose2[5];
    bestZ = pose2[8];
    double height =
        bestX * (pose1[9] - pose2[9])
            + bestY * (pose1[10] - pose2[10])
            + bestZ * (pose1[11] - pose2[11]);
    leastM = first.reach(pose1, bestX, bestY, bestZ) - height;
    if (leastM <= 0) {
      return 0;
    }
    meetAlongBest();
    return manifold.tell(found, leastM);
  }

  private void meetAlongBest() {
    manifold.frame.set(pose1, bestX, bestY, bestZ);
    manifold.find(first, pose1, second, pose2);
  }

  private boolean facesMeet() {
    meetAlongBest();
    return manifold.deepestM() > 0 && manifold.deepestM() > DEEP_SHARE * leastM - FACE_M;
  }

  /** Tries the directions out of the faces of a shape; whether they overlap in all of them. */
  private boolean faces(ConvexShape shape, double[] pose) {
    boolean overlap = true;
    for (int axis = shape.box ? 0 : 2; shape.flat && overlap && axis < 3; axis++) {
      overlap = overlap(pose[axis], pose[3 + axis], pose[6 + axis]);
    }
    return overlap;
  }

  /** Tries the directions across an edge, or an axis, of both; whether they overlap in all. */
  private boolean edges() {
    boolean overlap = true;
    for (int i = first.box ? 0 : 2; overlap && i < 3; i++) {
      for (int j = second.box ? 0 : 2; overlap && j < 3; j++) {
        double x = pose1[3 + i] * pose2[6 + j] - pose1[6 + i] * pose2[3 + j];
        double y = pose1[6 + i] * pose2[j] - pose1[i] * pose2[6 + j];
        double z = pose1[i] * pose2[3 + j] - pose1[3 + i] * pose2[j];
        double square = x * x + y * y + z * z;
        if (square > PARALLEL_2) {
          double scale = 1 / Math.sqrt(square);
          overlap = overlap(x * scale, y * scale, z * scale);
        }
      }
    }
    return overlap;
  }

  /** Tries the shortest way between the cores; whether they are apart. */
  private boolean cores() {
    double x = 0;
    double y = 0;
    double z = 0;
    boolean nearer = true;
    System.arraycopy(pose1, 9, onFirst, 0, 3);
    for (int step = 0; step < MAX_STEPS && nearer; step++) {
      System.arraycopy(onFirst, 0, onSecond, 0, 3);
      second.toCore(pose2, onSecond);
      System.arraycopy(onSecond, 0, onFirst, 0, 3);
      first.toCore(pose1, onFirst);
      double dx = onFirst[0] - onSecond[0] - x;
      double dy = onFirst[1] - onSecond[1] - y;
      double dz = onFirst[2] - onSecond[2] - z;
      x += dx;
      y += dy;
      z += dz;
      nearer = dx * dx + dy * dy + dz * dz > NEAR_M2;
    }
    double length = Math.sqrt(x * x + y * y + z * z);
    if (length * length < NEAR_M2) {
      return false;
    }
    overlap(x / length, y / length, z / length);
    return true;
  }

  /** Whether the shapes overlap along a direction of length 1; remembers the least overlap. */
  private boolean overlap(double x, double y, double z) {
    double apart =
        x * (pose1[9] - pose2[9]) + y * (pose1[10] - pose2[10]) + z * (pose1[11] - pose2[11]);
    double here = first.reach(pose1, x, y, z) + second.reach(pose2, x, y, z) - Math.abs(apart);
    if (here < leastM) {
      double sign = apart < 0 ? -1 : 1;
      leastM = here;
      bestX = sign * x;
      bestY = sign * y;
      bestZ = sign * z;
    }
    return here > 0;
  }
}
