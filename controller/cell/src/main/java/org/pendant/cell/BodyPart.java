package org.pendant.cell;

import org.ode4j.math.DMatrix3;
import org.ode4j.ode.DGeom;
import org.pendant.models.mesh.TriangleMesh;
import org.pendant.models.pose.Transforms;

/** Body part: a solid that is all of a body, or one of several that are rigidly joined. */
final class BodyPart {
  final BodyShape shape;
  final DGeom geom;

  /** Where it is in the base frame; that of the body where it is all of it. */
  final double[] pose;

  /** What contacts reckon with, if it is convex; else null. */
  final ConvexShape convex;

  /** Where others touch it, if it is made of triangles; else null. */
  final MeshContacts faces;

  /** No point of it is farther from its origin, m. */
  private final double reachM;

  /** Where it is in the body; null where it is all of it. */
  private final double[] inBody;

  private final double[] body;
  private final DMatrix3 rotation = new DMatrix3();

  /** Its corners, once hulls have asked for them. */
  private Polyhedron solid;

  /**
   * All of a body.
   *
   * @param body where that is, which whoever has the body changes
   */
  BodyPart(BodyShape shape, double[] body) {
    this(shape, body, body, null);
  }

  /** One of several in a body. */
  BodyPart(BodyShape.Compound.Part part, double[] body) {
    this(part.shape(), body, new double[Transforms.SIZE], new double[Transforms.SIZE]);
    Transforms.of(part.inBody(), inBody);
    follow();
  }

  private BodyPart(BodyShape shape, double[] body, double[] pose, double[] inBody) {
    this.shape = shape;
    this.body = body;
    this.pose = pose;
    this.inBody = inBody;
    geom = PhysicsLibrary.shape(shape, pose);
    convex = ConvexShape.of(shape);
    faces =
        shape instanceof BodyShape.Faces(TriangleMesh mesh) ? new MeshContacts(mesh, pose) : null;
    reachM = reachM(shape);
  }

  /** The body has moved. */
  void follow() {
    if (inBody != null) {
      Transforms.multiply(body, inBody, pose);
    }
    if (!(shape instanceof BodyShape.HalfSpace)) {
      geom.setPosition(pose[9], pose[10], pose[11]);
      geom.setRotation(
          rotation.set(
              pose[0], pose[1], pose[2], pose[3], pose[4], pose[5], pose[6], pose[7], pose[8]));
    }
  }

  /** No point of it is farther from its origin, m. */
  double reachM() {
    return reachM;
  }

  /** Whether it is a hull, which the physics library only knows as a ball. */
  boolean hull() {
    return shape instanceof BodyShape.Hull;
  }

  /** Its corners and faces, of a hull, a box or a cylinder. */
  Polyhedron solid() {
    if (solid == null) {
      solid = new Polyhedron(HullContacts.solid(shape), pose);
    }
    return solid;
  }

  /** Whether the bounds of both are apart. */
  boolean apart(BodyPart other) {
    return geom.getAABB().isDisjoint(other.geom.getAABB());
  }

  static double reachM(BodyShape shape) {
    return switch (shape) {
      case BodyShape.Box(double x, double y, double z) -> Math.sqrt(x * x + y * y + z * z) / 2;
      case BodyShape.Sphere(double radius) -> radius;
      case BodyShape.Cylinder(double radius, double length) -> Math.hypot(radius, length / 2);
      case BodyShape.Capsule(double radius, double length) -> radius + length / 2;
      case BodyShape.HalfSpace() -> Double.POSITIVE_INFINITY;
      case BodyShape.Hull hull -> hull.hull().reachM();
      case BodyShape.Faces(TriangleMesh mesh) -> mesh.reachM();
      case BodyShape.Compound(var parts, var _, var _, var _) -> {
        double most = 0;
        for (BodyShape.Compound.Part part : parts) {
          double away =
              Math.sqrt(
                  part.inBody().x() * part.inBody().x()
                      + part.inBody().y() * part.inBody().y()
                      + part.inBody().z() * part.inBody().z());
          most = Math.max(most, away + reachM(part.shape()));
        }
        yield most;
      }
    };
  }
}
