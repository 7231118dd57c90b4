package org.pendant.cell;

import java.util.Arrays;
import org.ode4j.ode.DContactGeomBuffer;
import org.pendant.models.mesh.ConvexHull;

/**
 * Hull contacts: where a convex hull and another body touch. The physics library does this as well,
 * but with one place for many pairs, on which nothing stands.
 *
 * <p>Solids with corners are held apart along the direction in which they overlap least, of those
 * of their faces and those across two edges (D. Gregorius: "The Separating Axis Test between Convex
 * Polyhedra", 2013). Where that is the direction of a face, the face that meets it is cut to what
 * is above it. Cylinders count as prisms of {@value #SIDES} sides here.
 */
final class HullContacts {
  private static final int SIDES = 32;

  /** A later direction has to be so much better than an earlier one, m: places stay. */
  private static final double BETTER_M = 5e-6;

  /** A face holds what meets it alone if that is at least so deep, as a share of the overlap. */
  private static final double DEEP_SHARE = 0.9;

  /** Depths that differ by less are alike, m: a flat face that rests leans by that. */
  private static final double ALIKE_M = 5e-5;

  /**
   * Solids that may be apart, though no face tells, are looked at across edges that are so near, m.
   */
  private static final double GAP_M = 2e-3;

  /** Corners that are no deeper are where a face was cut at the other, m. */
  private static final double ON_FACE_M = 1e-9;

  /** Edges with less than this between them, as a sine, have no direction across both. */
  private static final double PARALLEL = 1e-4;

  /** Corners of a face that is cut: each cut adds one at most. */
  private static final int MAX_CUT = 2 * ConvexHull.MAX_POINTS + 2;

  private final TouchCandidates candidates = new TouchCandidates();
  private final SegmentInHull segment = new SegmentInHull();
  private final double[] normal = new double[3];
  private final double[] axis = new double[3];
  private final double[] edgeAxis = new double[3];
  private final double[] lens6 = new double[6];
  private final int[] near1 = new int[3 * ConvexHull.MAX_POINTS];
  private final int[] near2 = new int[3 * ConvexHull.MAX_POINTS];
  private double[] cut = new double[3 * MAX_CUT];
  private double[] cutNext = new double[3 * MAX_CUT];

  /** A ball around what is cut, in the base frame, m. */
  private final double[] ballAt = new double[3];

  private double ballM;

  /** How far corners are out of a plane, or a middle of planes, m. */
  private final double[] outs = new double[MAX_CUT];

  private final double[] place = new double[3];
  private int bestFace;

  /** Whether the solids have a place in common for sure. */
  private boolean overlap;

  private int bestEdge1;
  private int bestEdge2;

  /** The corners of a shape that counts as a solid with corners. */
  static ConvexHull solid(BodyShape shape) {
    return switch (shape) {
      case BodyShape.Hull hull -> hull.hull();
      case BodyShape.Box(double x, double y, double z) -> ConvexHull.block(x, y, z);
      case BodyShape.Cylinder(double r, double length) -> ConvexHull.prism(SIDES, r, length);
      case BodyShape.Sphere _,
          BodyShape.Capsule _,
          BodyShape.HalfSpace _,
          BodyShape.Faces _,
          BodyShape.Compound _ ->
          throw new IllegalArgumentException("has no corners");
    };
  }

  /**
   * Where two parts of bodies touch, at least one of which is a hull.
   *
   * @param most places to be told, at most 4
   * @param found overwritten with them; normals lead out of the second one
   * @return how many there are
   */
  int find(BodyPart first, BodyPart second, int most, DContactGeomBuffer found) {
    candidates.clear();
    boolean hullFirst = first.shape instanceof BodyShape.Hull;
    BodyPart hull = hullFirst ? first : second;
    BodyPart other = hullFirst ? second : first;
    switch (other.shape) {
      case BodyShape.HalfSpace _ -> onPlane(hull.solid(), other.pose);
      case BodyShape.Sphere(double r) -> {
        double[] at = other.pose;
        ball(hull.solid(), at[9], at[10], at[11], r, hullFirst ? -1 : 1);
      }
      case BodyShape.Capsule(double r, double length) ->
          capsule(hull.solid(), other.pose, r, length, hullFirst ? -1 : 1);
      case BodyShape.Box _, BodyShape.Cylinder _, BodyShape.Hull _ ->
          solids(first.solid(), second.solid());
      case BodyShape.Faces _, BodyShape.Compound _ ->
          throw new IllegalStateException(
              "meshes find hulls themselves, and parts are no compounds");
    }
    return candidates.choose(most, found);
  }

  private void onPlane(Polyhedron solid, double[] plane) {
    solid.follow();
    for (int k = 0; k < 3; k++) {
      normal[k] = plane[3 * k + 2];
    }
    double height = normal[0] * plane[9] + normal[1] * plane[10] + normal[2] * plane[11];
    double[] p = solid.points;
    for (int i = 0; i < p.length; i += 3) {
      double depth = height - normal[0] * p[i] - normal[1] * p[i + 1] - normal[2] * p[i + 2];
      if (depth > 0) {
        candidates.put(p[i], p[i + 1], p[i + 2], normal, 1, depth);
      }
    }
  }

  private void ball(Polyhedron solid, double x, double y, double z, double r, double sign) {
    double depth = r - solid.away(x, y, z, normal);
    if (depth > 0) {
      candidates.put(x - r * normal[0], y - r * normal[1], z - r * normal[2], normal, sign, depth);
    }
  }

  private void capsule(Polyhedron solid, double[] at, double r, double length, double sign) {
    segment.set(at, length);
    segment.end(-1, place);
    ball(solid, place[0], place[1], place[2], r, sign);
    segment.end(1, place);
    ball(solid, place[0], place[1], place[2], r, sign);
    segment.nearest(solid, place);
    ball(solid, place[0], place[1], place[2], r, sign);
  }

  /** Whether two solids with corners overlap. */
  boolean overlap(Polyhedron one, Polyhedron other) {
    candidates.clear();
    return solids(one, other);
  }

  /** Finds where two solids touch; answers whether they do. */
  private boolean solids(Polyhedron one, Polyhedron other) {
    one.follow();
    other.follow();
    for (int k = 0; k < 3; k++) {
      lens6[k] = Math.max(one.box6[k], other.box6[k]);
      lens6[3 + k] = Math.min(one.box6[3 + k], other.box6[3 + k]);
      if (lens6[k] > lens6[3 + k]) {
        return false;
      }
    }
    double bySecond = bestFace(other, one);
    int secondFace = bestFace;
    if (bySecond > 0) {
      return false;
    }
    double byFirst = bestFace(one, other);
    int firstFace = bestFace;
    if (byFirst > 0) {
      return false;
    }
    boolean first = byFirst > bySecond + BETTER_M;
    boolean wide =
        first
            ? faceToFace(one, firstFace, other, -byFirst, -1)
            : faceToFace(other, secondFace, one, -bySecond, 1);
    if (wide) {
      return true;
    }
    double depthM = -Math.max(byFirst, bySecond);
    double nearM = overlap ? depthM : Math.max(depthM, GAP_M);
    int count1 = edgesNear(one, other, secondFace, nearM, near1);
    int count2 = count1 == 0 ? 0 : edgesNear(other, one, firstFace, nearM, near2);
    double byEdges = bestEdges(one, count1, other, count2, BETTER_M - depthM);
    if (byEdges > Double.NEGATIVE_INFINITY) {
      candidates.clear();
    }
    if (byEdges > 0) {
      return false;
    }
    if (byEdges > Double.NEGATIVE_INFINITY) {
      cross(one, other, -byEdges);
    } else if (!overlap) {
      return first ? lowestIn(one, other, depthM, -1) : lowestIn(other, one, depthM, 1);
    }
    return true;
  }

  /**
   * Whether two solids touch that may as well be apart across some edges: the corner of the other
   * that is lowest along {@link #normal} holds it if no place else does.
   */
  private boolean lowestIn(Polyhedron of, Polyhedron other, double depthM, double sign) {
    double[] p = other.points;
    int at = other.lowest(normal);
    if (!of.holds(p[at], p[at + 1], p[at + 2])
        && bestEdges(of, all(of, near1), other, all(other, near2), 0) > 0) {
      candidates.clear();
      return false;
    }
    if (candidates.empty()) {
      candidates.put(p[at], p[at + 1], p[at + 2], normal, sign, depthM);
    }
    return true;
  }

  /**
   * How far the other is out of the face that it is farthest out of, m; below 0 inside. Begins with
   * the face that its middle is farthest out of, which mostly is the one.
   */
  private double bestFace(Polyhedron of, Polyhedron other) {
    double[] p = of.planes;
    int faces = p.length / 4;
    double[] middle = other.pose;
    of.outs(middle[9], middle[10], middle[11], outs);
    bestFace = 0;
    for (int face = 1; face < faces; face++) {
      if (outs[face] > outs[bestFace] + BETTER_M) {
        bestFace = face;
      }
    }
    double best = other.least(p, bestFace);
    double inner = other.innerM;
    for (int face = 0; face < faces && best <= 0; face++) {
      // what is in it reaches at least as far as the ball within it, and as its lowest corner yet
      if (outs[face] - inner > best + BETTER_M && other.lowestOut(p, face) > best + BETTER_M) {
        double out = other.least(p, face);
        if (out > best + BETTER_M) {
          best = out;
          bestFace = face;
        }
      }
    }
    return best;
  }

  /**
   * How far both are apart along the best direction across two edges, m; minus infinite where none
   * is better than that.
   */
  private double bestEdges(Polyhedron one, int count1, Polyhedron other, int count2, double than) {
    double best = than;
    boolean any = false;
    for (int i = 0; i < count1; i++) {
      for (int j = 0; j < count2; j++) {
        if (across(one, near1[i], other, near2[j])) {
          int from = 3 * one.edges[near1[i]];
          int to = 3 * other.edges[near2[j]];
          double apart = 0;
          for (int k = 0; k < 3; k++) {
            apart += axis[k] * (one.points[from + k] - other.points[to + k]);
          }
          if (apart > best + BETTER_M) {
            best = apart;
            any = true;
            bestEdge1 = near1[i];
            bestEdge2 = near2[j];
            System.arraycopy(axis, 0, edgeAxis, 0, 3);
          }
        }
      }
    }
    return any ? best : Double.NEGATIVE_INFINITY;
  }

  /**
   * Edges of one solid that may hold the other one, or are nearest to it: they reach into the box
   * in which both are, and no face of the other is between. What holds it along some direction is
   * no farther out of it than it is deep along that direction, and thus than along the best face.
   *
   * @param face the one of the other that most edges are out of, as both are farthest apart there
   * @param found overwritten with them
   */
  private int edgesNear(Polyhedron of, Polyhedron other, int face, double depthM, int[] found) {
    double[] p = of.points;
    double[] planes = other.planes;
    double x = planes[4 * face];
    double y = planes[4 * face + 1];
    double z = planes[4 * face + 2];
    double most = planes[4 * face + 3] + depthM;
    for (int corner = 0, at = 0; at < p.length; corner++, at += 3) {
      outs[corner] = x * p[at] + y * p[at + 1] + z * p[at + 2] - most;
    }
    int count = 0;
    int[] edges = of.edges;
    for (int edge = 0; edge < edges.length; edge += 4) {
      int a = edges[edge];
      int b = edges[edge + 1];
      if ((outs[a] <= 0 || outs[b] <= 0)
          && inLens(p, 3 * a, 3 * b, depthM)
          && !outOfSome(other, p, 3 * a, 3 * b, depthM)) {
        found[count++] = edge;
      }
    }
    return count;
  }

  private static int all(Polyhedron of, int[] found) {
    for (int i = 0; 4 * i < of.edges.length; i++) {
      found[i] = 4 * i;
    }
    return of.edges.length / 4;
  }

  private boolean inLens(double[] p, int from, int to, double nearM) {
    for (int k = 0; k < 3; k++) {
      double a = p[from + k];
      double b = p[to + k];
      double least = lens6[k] - nearM;
      double most = lens6[3 + k] + nearM;
      if ((a > most && b > most) || (a < least && b < least)) {
        return false;
      }
    }
    return true;
  }

  /** Whether both ends of an edge are so far out of the same face. */
  private static boolean outOfSome(Polyhedron of, double[] p, int from, int to, double depthM) {
    for (int face = 0, faces = of.faces(); face < faces; face++) {
      if (of.out(face, p[from], p[from + 1], p[from + 2]) > depthM
          && of.out(face, p[to], p[to + 1], p[to + 2]) > depthM) {
        return true;
      }
    }
    return false;
  }

  /**
   * Finds the direction across two edges, out of the second solid; answers whether these edges can
   * touch from outside. They can if, on the sphere of directions, the arc between the faces at one
   * edge crosses that of the other.
   */
  private boolean across(Polyhedron one, int edge1, Polyhedron other, int edge2) {
    double[] p = one.planes;
    double[] q = other.planes;
    int a = 4 * one.edges[edge1 + 2];
    int b = 4 * one.edges[edge1 + 3];
    int c = 4 * other.edges[edge2 + 2];
    int d = 4 * other.edges[edge2 + 3];
    int from = 3 * one.edges[edge1];
    int to = 3 * one.edges[edge1 + 1];
    int start = 3 * other.edges[edge2];
    int end = 3 * other.edges[edge2 + 1];
    double ux = one.points[to] - one.points[from];
    double uy = one.points[to + 1] - one.points[from + 1];
    double uz = one.points[to + 2] - one.points[from + 2];
    double vx = other.points[end] - other.points[start];
    double vy = other.points[end + 1] - other.points[start + 1];
    double vz = other.points[end + 2] - other.points[start + 2];
    // the directions of the second one's faces are turned round
    double cu = -(q[c] * ux + q[c + 1] * uy + q[c + 2] * uz);
    double du = -(q[d] * ux + q[d + 1] * uy + q[d + 2] * uz);
    if (cu * du >= 0) {
      return false;
    }
    double av = p[a] * vx + p[a + 1] * vy + p[a + 2] * vz;
    double bv = p[b] * vx + p[b + 1] * vy + p[b + 2] * vz;
    if (av * bv >= 0 || cu * bv <= 0) {
      return false;
    }
    axis[0] = uy * vz - uz * vy;
    axis[1] = uz * vx - ux * vz;
    axis[2] = ux * vy - uy * vx;
    double length = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    double both = Math.sqrt((ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz));
    if (length <= PARALLEL * both) {
      return false;
    }
    double outward =
        axis[0] * (one.points[from] - one.pose[9])
            + axis[1] * (one.points[from + 1] - one.pose[10])
            + axis[2] * (one.points[from + 2] - one.pose[11]);
    for (int k = 0; k < 3; k++) {
      // out of the first solid there is into the second one
      axis[k] *= outward > 0 ? -1 / length : 1 / length;
    }
    return true;
  }

  /** Two edges cross: in the middle between their nearest places. */
  private void cross(Polyhedron one, Polyhedron other, double depth) {
    double[] p = one.points;
    double[] q = other.points;
    int from = 3 * one.edges[bestEdge1];
    int to = 3 * one.edges[bestEdge1 + 1];
    int start = 3 * other.edges[bestEdge2];
    int end = 3 * other.edges[bestEdge2 + 1];
    double uu = 0;
    double vv = 0;
    double uv = 0;
    double uw = 0;
    double vw = 0;
    for (int k = 0; k < 3; k++) {
      double u = p[to + k] - p[from + k];
      double v = q[end + k] - q[start + k];
      double w = p[from + k] - q[start + k];
      uu += u * u;
      vv += v * v;
      uv += u * v;
      uw += u * w;
      vw += v * w;
    }
    double area = uu * vv - uv * uv;
    double s = Math.clamp((uv * vw - vv * uw) / area, 0, 1);
    double t = Math.clamp((uu * vw - uv * uw) / area, 0, 1);
    for (int k = 0; k < 3; k++) {
      place[k] =
          0.5
              * (p[from + k]
                  + s * (p[to + k] - p[from + k])
                  + q[start + k]
                  + t * (q[end + k] - q[start + k]));
    }
    candidates.put(place[0], place[1], place[2], edgeAxis, 1, depth);
  }

  /**
   * Cuts the face of the other that meets a face to what is above it.
   *
   * @return whether what of it is inside is so wide that no direction across edges is much better:
   *     where both do not become narrower behind their faces, all between these is in both
   */
  private boolean faceToFace(
      Polyhedron of, int face, Polyhedron other, double overlapM, double sign) {
    for (int k = 0; k < 3; k++) {
      normal[k] = of.planes[4 * face + k];
    }
    int meets = other.against(normal);
    int count = 0;
    for (int i = other.firstCorner[meets]; i < other.firstCorner[meets + 1]; i++) {
      int from = 3 * other.corners[i];
      for (int k = 0; k < 3; k++) {
        cut[3 * count + k] = other.points[from + k];
      }
      outs[count] = of.out(face, cut[3 * count], cut[3 * count + 1], cut[3 * count + 2]);
      count++;
    }
    count = cutAtOuts(count);
    surround(count);
    int first = of.firstCorner[face];
    int corners = of.firstCorner[face + 1] - first;
    for (int i = 0; i < corners && count > 0; i++) {
      count =
          cutAlong(
              of.points,
              3 * of.corners[first + i],
              3 * of.corners[first + (i + 1 < corners ? i + 1 : 0)],
              count);
    }
    double deepest = 0;
    int at = 0;
    for (int i = 0; i < 3 * count; i += 3) {
      double depth = -of.out(face, cut[i], cut[i + 1], cut[i + 2]);
      if (depth > ON_FACE_M) {
        candidates.put(cut[i], cut[i + 1], cut[i + 2], normal, sign, depth);
        at = depth > deepest ? i : at;
        deepest = Math.max(deepest, depth);
      }
    }
    overlap = deepest > 0 && of.holds(cut[at], cut[at + 1], cut[at + 2]);
    return overlap
        && of.upright[face]
        && other.upright[meets]
        && deepest > DEEP_SHARE * overlapM - ALIKE_M
        && widthOfCut(count) > overlapM;
  }

  /** Finds a ball around what is cut: most edges need to look at no more than that. */
  private void surround(int count) {
    Arrays.fill(ballAt, 0);
    for (int i = 0; i < count; i++) {
      for (int k = 0; k < 3; k++) {
        ballAt[k] += cut[3 * i + k] / count;
      }
    }
    double most = 0;
    for (int i = 0; i < 3 * count; i += 3) {
      double x = cut[i] - ballAt[0];
      double y = cut[i + 1] - ballAt[1];
      double z = cut[i + 2] - ballAt[2];
      most = Math.max(most, x * x + y * y + z * z);
    }
    ballM = Math.sqrt(most);
  }

  /** The area of the face that was cut, over its border: less than half as wide as it is, m. */
  private double widthOfCut(int count) {
    double area = 0;
    double border = 0;
    for (int i = 0; i < count; i++) {
      int a = 3 * i;
      int b = 3 * ((i + 1) % count);
      double ux = cut[a] - cut[0];
      double uy = cut[a + 1] - cut[1];
      double uz = cut[a + 2] - cut[2];
      double vx = cut[b] - cut[0];
      double vy = cut[b + 1] - cut[1];
      double vz = cut[b + 2] - cut[2];
      area +=
          0.5
              * (normal[0] * (uy * vz - uz * vy)
                  + normal[1] * (uz * vx - ux * vz)
                  + normal[2] * (ux * vy - uy * vx));
      border += Math.sqrt((vx - ux) * (vx - ux) + (vy - uy) * (vy - uy) + (vz - uz) * (vz - uz));
    }
    return Math.abs(area) / border;
  }

  /** Leaves what is on the inner side of an edge of the face (I. Sutherland, G. Hodgman, 1974). */
  private int cutAlong(double[] points, int from, int to, int count) {
    double ex = points[to] - points[from];
    double ey = points[to + 1] - points[from + 1];
    double ez = points[to + 2] - points[from + 2];
    // out of the face
    double x = ey * normal[2] - ez * normal[1];
    double y = ez * normal[0] - ex * normal[2];
    double z = ex * normal[1] - ey * normal[0];
    double edge = x * points[from] + y * points[from + 1] + z * points[from + 2];
    double ball = ballM * Math.sqrt(x * x + y * y + z * z);
    double middle = x * ballAt[0] + y * ballAt[1] + z * ballAt[2] - edge;
    if (middle + ball <= 0) {
      return count;
    }
    if (middle - ball > 0) {
      return 0;
    }
    for (int i = 0; i < count; i++) {
      int a = 3 * i;
      outs[i] = x * cut[a] + y * cut[a + 1] + z * cut[a + 2] - edge;
    }
    return cutAtOuts(count);
  }

  /** Leaves what is on the inner side of a plane that corners are so far out of. */
  private int cutAtOuts(int count) {
    boolean whole = true;
    for (int i = 0; i < count; i++) {
      whole &= outs[i] <= 0;
    }
    if (whole) {
      return count;
    }
    int left = 0;
    for (int i = 0; i < count; i++) {
      int next = i + 1 < count ? i + 1 : 0;
      int a = 3 * i;
      int b = 3 * next;
      double outA = outs[i];
      double outB = outs[next];
      if (outA <= 0) {
        System.arraycopy(cut, a, cutNext, 3 * left++, 3);
      }
      if (outA < 0 != outB < 0 && outA != 0 && outB != 0) {
        double share = outA / (outA - outB);
        for (int k = 0; k < 3; k++) {
          cutNext[3 * left + k] = cut[a + k] + share * (cut[b + k] - cut[a + k]);
        }
        left++;
      }
    }
    double[] swapped = cut;
    cut = cutNext;
    cutNext = swapped;
    return left;
  }
}
