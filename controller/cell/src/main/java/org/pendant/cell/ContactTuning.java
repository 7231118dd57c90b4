package org.pendant.cell;

import org.ode4j.math.DVector3C;
import org.ode4j.ode.DContact;
import org.ode4j.ode.OdeConstants;

/**
 * Contact tuning: what the solver is told of one place where two bodies touch, the first of them a
 * free one.
 *
 * <p>Friction is along the sliding, so that it is that of Coulomb's law in every direction. Where
 * nothing slides, it takes the direction of the tiny creep that the solver leaves, which is that of
 * the load.
 */
final class ContactTuning {
  /** Depth at which bodies rest in one another, so that contacts do not flicker, m. */
  static final double LAYER_M = 1e-4;

  /** Share of the depth beyond this layer that one step takes back. */
  private static final double RECOVERY = 0.2;

  /** Most depth that is taken back with this haste, m: bodies never burst apart. */
  private static final double DEEPEST_M = 2e-3;

  /** Give of hard contacts, s/kg: they are often held by more places than they need. */
  private static final double GIVE = 1e-9;

  /** Creep of friction that holds, m/s for each N: 6 micrometres in 10 minutes for 1 N. */
  private static final double CREEP = 1e-8;

  /** Slower impacts do not bounce, m/s. */
  private static final double LEAST_BOUNCE = 0.02;

  /** Slower than this nothing says where it slides, m/s. */
  private static final double LEAST_SLIDING = 1e-9;

  /** From this speed on nothing holds sideways any more, m/s. */
  private static final double ONLY_SLIDING = 1e-3;

  /** Damping of guided contacts, 1 would be without any overshoot. */
  private static final double DAMPING_RATIO = 0.7;

  private final double[] sliding = new double[3];

  /** Sets one of {@code places} contacts between these bodies up, for a step of {@code stepS}. */
  void set(DContact contact, RigidBody first, RigidBody second, int places, double stepS) {
    BodySurface a = first.description.surface();
    BodySurface b = second.description.surface();
    DContact.DSurfaceParameters s = contact.surface;
    s.mode = OdeConstants.dContactSoftERP | OdeConstants.dContactSoftCFM;
    if (second.guided()) {
      double stiffness = Math.min(a.stiffnessNPerM(), b.stiffnessNPerM()) / places;
      double damping =
          2 * DAMPING_RATIO * Math.sqrt(stiffness * first.description.massKg() / places);
      double both = stepS * stiffness + damping;
      s.soft_erp = stepS * stiffness / both;
      s.soft_cfm = 1 / both;
      contact.geom.depth += LAYER_M;
    } else {
      s.soft_erp = RECOVERY;
      s.soft_cfm = GIVE;
      contact.geom.depth = Math.min(contact.geom.depth, LAYER_M + DEEPEST_M);
      s.bounce = Math.max(a.restitution(), b.restitution());
      s.bounce_vel = LEAST_BOUNCE;
      if (s.bounce > 0) {
        s.mode |= OdeConstants.dContactBounce;
      }
    }
    setFriction(contact, first, second, Math.sqrt(a.friction() * b.friction()));
  }

  private void setFriction(DContact contact, RigidBody first, RigidBody second, double friction) {
    DContact.DSurfaceParameters s = contact.surface;
    s.mu = friction;
    s.mu2 = friction;
    s.slip1 = CREEP;
    s.slip2 = CREEP;
    s.mode |=
        OdeConstants.dContactApprox1
            | OdeConstants.dContactAxisDep
            | OdeConstants.dContactSlip1
            | OdeConstants.dContactSlip2;
    sliding[0] = 0;
    sliding[1] = 0;
    sliding[2] = 0;
    addVelocity(first, contact.geom.pos, 1);
    if (second.body != null) {
      addVelocity(second, contact.geom.pos, -1);
    }
    DVector3C n = contact.geom.normal;
    double leaving = sliding[0] * n.get0() + sliding[1] * n.get1() + sliding[2] * n.get2();
    double x = sliding[0] - leaving * n.get0();
    double y = sliding[1] - leaving * n.get1();
    double z = sliding[2] - leaving * n.get2();
    double speed = Math.sqrt(x * x + y * y + z * z);
    if (speed > LEAST_SLIDING) {
      s.mode |= OdeConstants.dContactFDir1;
      contact.fdir1.set(x / speed, y / speed, z / speed);
      s.mu2 = friction * Math.max(0, 1 - speed / ONLY_SLIDING);
    }
  }

  private void addVelocity(RigidBody of, DVector3C at, double sign) {
    DVector3C p = of.body.getPosition();
    DVector3C v = of.body.getLinearVel();
    DVector3C w = of.body.getAngularVel();
    double x = at.get0() - p.get0();
    double y = at.get1() - p.get1();
    double z = at.get2() - p.get2();
    sliding[0] += sign * (v.get0() + w.get1() * z - w.get2() * y);
    sliding[1] += sign * (v.get1() + w.get2() * x - w.get0() * z);
    sliding[2] += sign * (v.get2() + w.get0() * y - w.get1() * x);
  }
}
