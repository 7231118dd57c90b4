package org.pendant.controller.world;

import org.pendant.models.json.Range;

/**
 * Material: how a surface pushes back.
 *
 * <p>The normal force follows K. H. Hunt and F. R. E. Crossley, "Coefficient of restitution
 * interpreted as damping in vibroimpact" (1975), with a linear spring: {@code f = k d (1 - 1.5 e
 * v)}, where v is the speed out of the surface. It sets in without a step, takes energy out of an
 * impact, and never pulls. Friction is Coulomb's, with a ramp instead of the step at rest: below
 * {@value #CREEP_M_PER_S} m/s (or the speed at which {@value #MAX_DRAG_N_S_PER_M} N s/m reach the
 * full friction, if that is more) it is proportional to the speed. So nothing sticks: what is
 * pushed sideways by less than the friction creeps.
 *
 * <p>The ranges keep explicit steps stable for masses of 2 kg and more: 2 ms against the stiffest
 * spring ({@code dt < 2 sqrt(m/k)}), 1 ms against the steepest friction ({@code dt < 2 m/c}).
 *
 * @param stiffnessNPerM spring rate k, 10 to 200,000 N/m
 * @param dampingSPerM Hunt and Crossley's e, 0 to 2 s/m: the share of the speed that a slow impact
 *     loses, for each m/s of it
 * @param friction Coulomb's coefficient, 0 to 2
 * @param restitution share of its speed with which an object that has a mass comes back from it, 0
 *     to 1; the larger one of two counts
 */
public record Material(
    double stiffnessNPerM, double dampingSPerM, double friction, double restitution) {
  static final Range STIFFNESS = new Range(10, 2e5, "N/m");
  static final Range DAMPING = new Range(0, 2, "s/m");
  static final Range FRICTION = new Range(0, 2, "");
  static final Range RESTITUTION = new Range(0, 1, "");

  /** Sliding slower than this meets less than the full friction, m/s. */
  static final double CREEP_M_PER_S = 1e-3;

  /** Friction rises with speed by no more than this, N s/m. */
  static final double MAX_DRAG_N_S_PER_M = 4000;

  /** What a surface is of when nothing else is said: 1 mm deep under 40 N. */
  public static final Material DEFAULT = new Material(4e4, 0.2, 0.3);

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is outside its range
   */
  public Material {
    STIFFNESS.require("stiffness", stiffnessNPerM);
    DAMPING.require("damping", dampingSPerM);
    FRICTION.require("friction", friction);
    RESTITUTION.require("restitution", restitution);
  }

  /** One from which nothing bounces. */
  public Material(double stiffnessNPerM, double dampingSPerM, double friction) {
    this(stiffnessNPerM, dampingSPerM, friction, 0);
  }

  /**
   * The force out of the surface, N, never negative.
   *
   * @param depthM how deep something is pressed in, m, at least 0
   * @param leavingMPerS its speed out of the surface, m/s
   */
  double normalForceN(double depthM, double leavingMPerS) {
    return Math.max(0, stiffnessNPerM * depthM * (1 - 1.5 * dampingSPerM * leavingMPerS));
  }

  /**
   * Friction for each m/s of sliding, N s/m.
   *
   * @param normalForceN force out of the surface, N
   * @param slidingMPerS speed along the surface, m/s, at least 0
   */
  double dragNSPerM(double normalForceN, double slidingMPerS) {
    double drag = friction * normalForceN / Math.max(slidingMPerS, CREEP_M_PER_S);
    return Math.min(drag, MAX_DRAG_N_S_PER_M);
  }
}
