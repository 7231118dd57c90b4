package org.pendant.cell;

import org.ode4j.ode.DContactGeomBuffer;
import org.pendant.models.mesh.ConvexHull;
import org.pendant.models.mesh.MeshDistance;
import org.pendant.models.mesh.MeshPoints;
import org.pendant.models.mesh.TriangleMesh;

/**
 * Mesh contacts: where bodies touch one that is made of triangles. Corners and rims of the body are
 * looked for in the mesh, and points of the mesh in the body; edges that cross each other in the
 * middle go a little deeper before one of these notices.
 *
 * <p>The physics library finds no place between a cylinder and triangles, and those of a box one
 * triangle after the other, so that four of them are not its corners.
 */
final class MeshContacts {
  /** Cylinders that lean less than this, as a sine, stand on four places of their rim. */
  private static final double STANDING = 0.05;

  /** An edge of a hull is long from this share of its reach on. */
  private static final double LONG_EDGE = 0.5;

  private final MeshDistance distance;
  private final MeshPoints points;
  private final double[] mesh;
  private final double[] normal = new double[3];
  private final double[] local = new double[3];
  private final double[] out = new double[3];
  private final TouchCandidates candidates = new TouchCandidates();
  private BodyPart body;

  /** Kept, so that a step allocates none. */
  private final MeshPoints.Taker taker = this::takePoint;

  /**
   * Contacts with a mesh that stays where it is.
   *
   * @param pose12 where, as {@link org.pendant.models.pose.Transforms} has it
   */
  MeshContacts(TriangleMesh triangles, double[] pose12) {
    distance = new MeshDistance(triangles);
    points = new MeshPoints(triangles);
    mesh = pose12.clone();
  }

  /**
   * Where a body touches it.
   *
   * @param most places to be told, at most 4
   * @param found overwritten with them; normals lead into the body
   * @return how many there are
   */
  int find(BodyPart of, int most, DContactGeomBuffer found) {
    body = of;
    candidates.clear();
    double[] pose = of.pose;
    double centreM = inMesh(pose[9], pose[10], pose[11]);
    double reachM = of.reachM();
    if (centreM > reachM) {
      return 0;
    }
    switch (of.shape) {
      case BodyShape.Box(double x, double y, double z) -> addBox(x / 2, y / 2, z / 2);
      case BodyShape.Sphere(double r) -> add(0, 0, 0, r);
      case BodyShape.Capsule(double r, double length) -> {
        for (int i = -2; i <= 2; i++) {
          add(0, 0, i * length / 4, r);
        }
      }
      case BodyShape.Cylinder(double r, double length) -> addRims(r, length / 2);
      case BodyShape.Hull hull -> addCorners(hull.hull());
      case BodyShape.HalfSpace _, BodyShape.Faces _, BodyShape.Compound _ -> {
        // neither moves
      }
    }
    double x = pose[9] - mesh[9];
    double y = pose[10] - mesh[10];
    double z = pose[11] - mesh[11];
    points.near(own(mesh, 0, x, y, z), own(mesh, 1, x, y, z), own(mesh, 2, x, y, z), reachM, taker);
    return candidates.choose(most, found);
  }

  private void addBox(double x, double y, double z) {
    for (int corner = 0; corner < 8; corner++) {
      add(sign(corner, 1) * x, sign(corner, 2) * y, sign(corner, 4) * z, 0);
    }
    for (int side = 0; side < 4; side++) {
      add(0, sign(side, 1) * y, sign(side, 2) * z, 0);
      add(sign(side, 1) * x, 0, sign(side, 2) * z, 0);
      add(sign(side, 1) * x, sign(side, 2) * y, 0, 0);
    }
  }

  /** Corners of a hull, and the middles of its long edges: those of a mesh may cross them. */
  private void addCorners(ConvexHull hull) {
    double longM = LONG_EDGE * body.reachM();
    for (int i = 0; i < hull.points(); i++) {
      add(hull.coordinate(i, 0), hull.coordinate(i, 1), hull.coordinate(i, 2), 0);
    }
    for (int edge = 0; edge < hull.edges(); edge++) {
      int from = hull.edge(edge, 0);
      int to = hull.edge(edge, 1);
      double x = hull.coordinate(to, 0) - hull.coordinate(from, 0);
      double y = hull.coordinate(to, 1) - hull.coordinate(from, 1);
      double z = hull.coordinate(to, 2) - hull.coordinate(from, 2);
      if (x * x + y * y + z * z < longM * longM) {
        continue;
      }
      add(
          (hull.coordinate(from, 0) + hull.coordinate(to, 0)) / 2,
          (hull.coordinate(from, 1) + hull.coordinate(to, 1)) / 2,
          (hull.coordinate(from, 2) + hull.coordinate(to, 2)) / 2,
          0);
    }
  }

  private static int sign(int number, int bit) {
    return (number & bit) == 0 ? -1 : 1;
  }

  /** The lowest place of both rims as seen from the mesh, and three more on each. */
  private void addRims(double r, double half) {
    double[] pose = body.pose;
    double x = own(pose, 0, normal[0], normal[1], normal[2]);
    double y = own(pose, 1, normal[0], normal[1], normal[2]);
    double lean = Math.sqrt(x * x + y * y);
    double cosine = lean < STANDING ? 1 : -x / lean;
    double sine = lean < STANDING ? 0 : -y / lean;
    for (int end = -1; end <= 1; end += 2) {
      add(r * cosine, r * sine, end * half, 0);
      add(-r * sine, r * cosine, end * half, 0);
      add(-r * cosine, -r * sine, end * half, 0);
      add(r * sine, -r * cosine, end * half, 0);
    }
  }

  /** Looks for a ball of the body, along its own axes, in the mesh. */
  private void add(double x, double y, double z, double radiusM) {
    double[] p = body.pose;
    double inBaseX = p[9] + p[0] * x + p[1] * y + p[2] * z;
    double inBaseY = p[10] + p[3] * x + p[4] * y + p[5] * z;
    double inBaseZ = p[11] + p[6] * x + p[7] * y + p[8] * z;
    double depth = radiusM - inMesh(inBaseX, inBaseY, inBaseZ);
    if (depth > 0) {
      candidates.put(
          inBaseX - radiusM * normal[0],
          inBaseY - radiusM * normal[1],
          inBaseZ - radiusM * normal[2],
          normal,
          1,
          depth);
    }
  }

  /** How far a place of the base is from the mesh; {@link #normal} leads out of it there. */
  private double inMesh(double atX, double atY, double atZ) {
    double x = atX - mesh[9];
    double y = atY - mesh[10];
    double z = atZ - mesh[11];
    double away =
        distance.toPoint(
            own(mesh, 0, x, y, z), own(mesh, 1, x, y, z), own(mesh, 2, x, y, z), local);
    turn(mesh, local, 1);
    return away;
  }

  /** Looks for a point of the mesh in the body. */
  private void takePoint(double x, double y, double z) {
    double inBaseX = mesh[9] + mesh[0] * x + mesh[1] * y + mesh[2] * z;
    double inBaseY = mesh[10] + mesh[3] * x + mesh[4] * y + mesh[5] * z;
    double inBaseZ = mesh[11] + mesh[6] * x + mesh[7] * y + mesh[8] * z;
    double[] pose = body.pose;
    double dx = inBaseX - pose[9];
    double dy = inBaseY - pose[10];
    double dz = inBaseZ - pose[11];
    double depth =
        ShapeDepth.of(
            body.shape,
            own(pose, 0, dx, dy, dz),
            own(pose, 1, dx, dy, dz),
            own(pose, 2, dx, dy, dz),
            out);
    if (depth > 0) {
      turn(pose, out, -1);
      candidates.put(inBaseX, inBaseY, inBaseZ, normal, 1, depth);
    }
  }

  private void turn(double[] frame, double[] vector, double sign) {
    for (int row = 0; row < 3; row++) {
      normal[row] =
          sign
              * (frame[3 * row] * vector[0]
                  + frame[3 * row + 1] * vector[1]
                  + frame[3 * row + 2] * vector[2]);
    }
  }

  private static double own(double[] frame, int axis, double x, double y, double z) {
    return frame[axis] * x + frame[3 + axis] * y + frame[6 + axis] * z;
  }
}
