package org.pendant.models.dynamics;

import org.ejml.data.DMatrix3x3;
import org.ejml.dense.fixed.CommonOps_DDF3;
import org.pendant.models.arm.LinkMass;

/**
 * A body in the frame of the link that carries it: mass, centre of mass, and inertia about that
 * centre along the frame's axes. Bodies add up when they are welded together.
 *
 * @param m mass, kg
 * @param cx centre of mass, m
 * @param cy centre of mass, m
 * @param cz centre of mass, m
 * @param inertia inertia tensor, kg m²; shared between bodies, so never changed
 */
record RigidBody(double m, double cx, double cy, double cz, DMatrix3x3 inertia) {

  static RigidBody of(LinkMass link) {
    return new RigidBody(
        link.massKg(),
        link.comXM(),
        link.comYM(),
        link.comZM(),
        tensor(link.ixx(), link.ixy(), link.ixz(), link.iyy(), link.iyz(), link.izz()));
  }

  static RigidBody of(Payload payload) {
    return new RigidBody(
        payload.massKg(),
        payload.cogXM(),
        payload.cogYM(),
        payload.cogZM(),
        tensor(
            payload.ixx(),
            payload.ixy(),
            payload.ixz(),
            payload.iyy(),
            payload.iyz(),
            payload.izz()));
  }

  /** This body and another one, both in the same frame, as one. */
  RigidBody weldedTo(RigidBody other) {
    double sum = m + other.m;
    double x = (m * cx + other.m * other.cx) / sum;
    double y = (m * cy + other.m * other.cy) / sum;
    double z = (m * cz + other.m * other.cz) / sum;
    DMatrix3x3 inertia = new DMatrix3x3();
    CommonOps_DDF3.add(about(x, y, z).inertia, other.about(x, y, z).inertia, inertia);
    return new RigidBody(sum, x, y, z, inertia);
  }

  /** The same body with its inertia about another point; by the parallel axis theorem. */
  RigidBody about(double x, double y, double z) {
    double dx = cx - x;
    double dy = cy - y;
    double dz = cz - z;
    DMatrix3x3 moved =
        tensor(
            m * (dy * dy + dz * dz),
            -m * dx * dy,
            -m * dx * dz,
            m * (dx * dx + dz * dz),
            -m * dy * dz,
            m * (dx * dx + dy * dy));
    CommonOps_DDF3.addEquals(moved, inertia);
    return new RigidBody(m, cx, cy, cz, moved);
  }

  private static DMatrix3x3 tensor(
      double xx, double xy, double xz, double yy, double yz, double zz) {
    return new DMatrix3x3(xx, xy, xz, xy, yy, yz, xz, yz, zz);
  }
}
