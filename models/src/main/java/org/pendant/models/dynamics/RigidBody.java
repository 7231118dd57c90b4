package org.pendant.models.dynamics;

import org.pendant.models.arm.LinkMass;

/**
 * A body in the frame of the link that carries it: mass, centre of mass, and inertia about that
 * centre along the frame's axes. Bodies add up when they are welded together.
 *
 * @param m mass, kg
 * @param cx centre of mass, m
 * @param cy centre of mass, m
 * @param cz centre of mass, m
 * @param xx inertia, kg m²
 * @param xy inertia, kg m²
 * @param xz inertia, kg m²
 * @param yy inertia, kg m²
 * @param yz inertia, kg m²
 * @param zz inertia, kg m²
 */
record RigidBody(
    double m,
    double cx,
    double cy,
    double cz,
    double xx,
    double xy,
    double xz,
    double yy,
    double yz,
    double zz) {

  static RigidBody of(LinkMass link) {
    return new RigidBody(
        link.massKg(),
        link.comXM(),
        link.comYM(),
        link.comZM(),
        link.ixx(),
        link.ixy(),
        link.ixz(),
        link.iyy(),
        link.iyz(),
        link.izz());
  }

  static RigidBody of(Payload payload) {
    return new RigidBody(
        payload.massKg(),
        payload.cogXM(),
        payload.cogYM(),
        payload.cogZM(),
        payload.ixx(),
        payload.ixy(),
        payload.ixz(),
        payload.iyy(),
        payload.iyz(),
        payload.izz());
  }

  /** This body and another one, both in the same frame, as one. */
  RigidBody weldedTo(RigidBody other) {
    double sum = m + other.m;
    double x = (m * cx + other.m * other.cx) / sum;
    double y = (m * cy + other.m * other.cy) / sum;
    double z = (m * cz + other.m * other.cz) / sum;
    RigidBody one = about(x, y, z);
    RigidBody two = other.about(x, y, z);
    return new RigidBody(
        sum,
        x,
        y,
        z,
        one.xx + two.xx,
        one.xy + two.xy,
        one.xz + two.xz,
        one.yy + two.yy,
        one.yz + two.yz,
        one.zz + two.zz);
  }

  /** The same body with its inertia about another point; by the parallel axis theorem. */
  RigidBody about(double x, double y, double z) {
    double dx = cx - x;
    double dy = cy - y;
    double dz = cz - z;
    return new RigidBody(
        m,
        cx,
        cy,
        cz,
        xx + m * (dy * dy + dz * dz),
        xy - m * dx * dy,
        xz - m * dx * dz,
        yy + m * (dx * dx + dz * dz),
        yz - m * dy * dz,
        zz + m * (dx * dx + dy * dy));
  }
}
