package org.pendant.cell;

import org.ode4j.ode.DContactGeom;

/**
 * Contact place: where two bodies touch, the first of them a free one, and the impulse there.
 *
 * <p>Impulses are found one place after the other, again and again: each pushes its two bodies
 * apart as it must with the speeds that the others have left them. Friction is an impulse in the
 * plane of contact that stays within Coulomb's cone, the same in all directions.
 */
final class ContactPlace {
  /** Depth at which bodies rest in one another, so that contacts do not come and go, m. */
  private static final double LAYER_M = 1e-4;

  /** Share of the depth beyond this layer that one step takes back. */
  private static final double RECOVERY = 0.2;

  /** Most depth that is taken back with this haste, m: bodies never burst apart. */
  private static final double MAX_DEPTH_M = 2e-3;

  /** Slower impacts do not bounce, m/s. */
  private static final double MIN_BOUNCE = 0.03;

  /** Damping of contacts with kinematic bodies; 1 would be without any overshoot. */
  private static final double DAMPING_RATIO = 0.7;

  CellBody first;
  CellBody second;

  /** Which parts of both touch here. */
  int parts;

  /** Of the impulse on the first body: its share along the normal, Ns. */
  double normalImpulse;

  private double tangentImpulse1;
  private double tangentImpulse2;

  /** Normal, out of the second body, and two directions at right angles to it. */
  private final double[] normal = new double[3];

  private final double[] tangent1 = new double[3];
  private final double[] tangent2 = new double[3];
  private final ContactRow alongNormal = new ContactRow();
  private final ContactRow along1 = new ContactRow();
  private final ContactRow along2 = new ContactRow();

  /** From the origins of the bodies to here. */
  private final double[] arm1 = new double[3];

  private final double[] arm2 = new double[3];

  /** Where this is on the first body, along its own axes. */
  private final double[] onFirst = new double[3];

  /** Speed along the normal that an impulse of 1 Ns along a tangent gives, m/s. */
  private double normalOf1;

  private double normalOf2;
  private boolean secondMoves;
  private double normalMass;
  private double tangentMass;
  private double softness;
  private double leavingSpeed;
  private double friction;

  /** Speed of the second body's surface along the tangents, m/s. */
  private double belt1;

  private double belt2;

  /** Takes over what was found, one of {@code places} between these two. */
  void set(CellBody one, CellBody other, DContactGeom found, int places, double stepS) {
    first = one;
    second = other;
    normalImpulse = 0;
    tangentImpulse1 = 0;
    tangentImpulse2 = 0;
    for (int i = 0; i < 3; i++) {
      normal[i] = found.normal.get(i);
      arm1[i] = found.pos.get(i) - one.pose[9 + i];
      arm2[i] = found.pos.get(i) - other.pose[9 + i];
    }
    for (int i = 0; i < 3; i++) {
      onFirst[i] = one.pose[i] * arm1[0] + one.pose[3 + i] * arm1[1] + one.pose[6 + i] * arm1[2];
    }
    ContactFrame.across(normal, tangent1, tangent2);
    alongNormal.set(one, arm1, other, arm2, normal);
    along1.set(one, arm1, other, arm2, tangent1);
    along2.set(one, arm1, other, arm2, tangent2);
    belt1 = dot(other.belt, tangent1);
    belt2 = dot(other.belt, tangent2);
    BodySurface a = one.description.surface();
    BodySurface b = other.description.surface();
    friction = Math.sqrt(a.friction() * b.friction());
    double yielding = alongNormal.yielding(alongNormal);
    softness = 0;
    if (other.kinematic()) {
      double stiffness = Math.min(a.stiffnessNPerM(), b.stiffnessNPerM()) / places;
      double damping = 2 * DAMPING_RATIO * Math.sqrt(stiffness / (one.inverseMass * places));
      softness = 1 / (stepS * (damping + stepS * stiffness));
      leavingSpeed = found.depth * stepS * stiffness * softness;
    } else {
      double depth = Math.min(found.depth - LAYER_M, MAX_DEPTH_M);
      leavingSpeed = RECOVERY * Math.max(0, depth) / stepS;
      double approaching = -alongNormal.speed();
      if (approaching > MIN_BOUNCE) {
        leavingSpeed =
            Math.max(leavingSpeed, Math.max(a.restitution(), b.restitution()) * approaching);
      }
    }
    normalMass = 1 / (yielding + softness);
    normalOf1 = alongNormal.yielding(along1);
    normalOf2 = alongNormal.yielding(along2);
    secondMoves = other.description.motion() != BodyMotion.FIXED;
    double k11 = along1.yielding(along1);
    double k22 = along2.yielding(along2);
    double k12 = along1.yielding(along2);
    // the largest eigenvalue: with one mass for both directions friction ends up along the sliding
    tangentMass = 1 / (0.5 * (k11 + k22) + Math.hypot(0.5 * (k11 - k22), k12));
  }

  /** How far this place on the first body is from another one on it, squared, m^2. */
  double squareTo(ContactPlace other) {
    double x = onFirst[0] - other.onFirst[0];
    double y = onFirst[1] - other.onFirst[1];
    double z = onFirst[2] - other.onFirst[2];
    return x * x + y * y + z * z;
  }

  /** Begins with the impulse that held here in the step before. */
  void beginWith(ContactPlace before) {
    normalImpulse = before.normalImpulse;
    double x = before.tangentImpulse(0);
    double y = before.tangentImpulse(1);
    double z = before.tangentImpulse(2);
    tangentImpulse1 = x * tangent1[0] + y * tangent1[1] + z * tangent1[2];
    tangentImpulse2 = x * tangent2[0] + y * tangent2[1] + z * tangent2[2];
    ContactRow.hit(alongNormal, normalImpulse, along1, tangentImpulse1, along2, tangentImpulse2);
  }

  /** Corrects the impulse; answers by how much, Ns. */
  double solve() {
    double[] one = first.twist;
    double[] arm = arm1;
    double vx = one[0] + one[4] * arm[2] - one[5] * arm[1];
    double vy = one[1] + one[5] * arm[0] - one[3] * arm[2];
    double vz = one[2] + one[3] * arm[1] - one[4] * arm[0];
    if (secondMoves) {
      double[] other = second.twist;
      arm = arm2;
      vx -= other[0] + other[4] * arm[2] - other[5] * arm[1];
      vy -= other[1] + other[5] * arm[0] - other[3] * arm[2];
      vz -= other[2] + other[3] * arm[1] - other[4] * arm[0];
    }
    double t1 = tangentImpulse1 - tangentMass * (along1.part(vx, vy, vz) - belt1);
    double t2 = tangentImpulse2 - tangentMass * (along2.part(vx, vy, vz) - belt2);
    double most = friction * normalImpulse;
    double square = t1 * t1 + t2 * t2;
    if (square > most * most) {
      double share = most / Math.sqrt(square);
      t1 *= share;
      t2 *= share;
    }
    double d1 = t1 - tangentImpulse1;
    double d2 = t2 - tangentImpulse2;
    double speed = alongNormal.part(vx, vy, vz) + d1 * normalOf1 + d2 * normalOf2;
    double n = normalImpulse + normalMass * (leavingSpeed - speed - softness * normalImpulse);
    n = n > 0 ? n : 0;
    double dn = n - normalImpulse;
    tangentImpulse1 = t1;
    tangentImpulse2 = t2;
    normalImpulse = n;
    ContactRow.hit(alongNormal, dn, along1, d1, along2, d2);
    return Math.abs(dn) + Math.abs(d1) + Math.abs(d2);
  }

  /** Adds what this does to the second body, as force and torque, to its wrench. */
  void addWrench(double stepS) {
    double fx = -impulse(0) / stepS;
    double fy = -impulse(1) / stepS;
    double fz = -impulse(2) / stepS;
    double[] wrench = second.wrench;
    wrench[0] += fx;
    wrench[1] += fy;
    wrench[2] += fz;
    wrench[3] += arm2[1] * fz - arm2[2] * fy;
    wrench[4] += arm2[2] * fx - arm2[0] * fz;
    wrench[5] += arm2[0] * fy - arm2[1] * fx;
  }

  /** The impulse on the first body, Ns. */
  double impulse() {
    return Math.sqrt(impulse(0) * impulse(0) + impulse(1) * impulse(1) + impulse(2) * impulse(2));
  }

  private double impulse(int axis) {
    return normalImpulse * normal[axis] + tangentImpulse(axis);
  }

  private double tangentImpulse(int axis) {
    return tangentImpulse1 * tangent1[axis] + tangentImpulse2 * tangent2[axis];
  }

  private static double dot(double[] one, double[] other) {
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
  }
}
