package org.pendant.models.arm;

/**
 * Friction curve: the current that the friction of a joint takes at a speed v under a load,
 *
 * <pre>  (coulomb + perNm |load|) tanh(v / 0.0079) + curved tanh(v / v1) + viscous v.</pre>
 *
 * <p>It is concave: its slope at a rad/s is about a third of that at a tenth. The first term is the
 * passage through standstill as controllers reckon with it; a joint that truly stands still is held
 * by dry friction up to the whole of {@link #dryA}.
 *
 * @param coulombA dry friction, which does not depend on the speed, A
 * @param curvedA what the curved part comes to at high speed, A
 * @param curveSpeedRadPerS speed v1 of the curved part, rad/s
 * @param viscousASPerRad friction that grows evenly with the speed, A s/rad
 * @param loadAPerNm dry friction that comes with each Nm of load, A/Nm
 */
public record FrictionCurve(
    double coulombA,
    double curvedA,
    double curveSpeedRadPerS,
    double viscousASPerRad,
    double loadAPerNm) {
  /** No friction at all. */
  public static final FrictionCurve NONE = new FrictionCurve(0, 0, 1, 0, 0);

  /** Speed over which the Coulomb part passes through standstill, rad/s. */
  private static final double TRANSITION_RAD_PER_S = 0.0079;

  /** Here and beyond the hyperbolic tangent is 1 to the last bit. */
  private static final double TANH_IS_ONE = 20;

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is negative or infinite, or the speed not above 0
   */
  public FrictionCurve {
    if (!notNegative(coulombA)
        || !notNegative(curvedA)
        || !notNegative(viscousASPerRad)
        || !notNegative(loadAPerNm)) {
      throw new IllegalArgumentException(
          "friction: coulombA is "
              + coulombA
              + " A, curvedA "
              + curvedA
              + " A, viscousASPerRad "
              + viscousASPerRad
              + " A s/rad, loadAPerNm "
              + loadAPerNm
              + " A/Nm, none may be negative");
    }
    if (!(curveSpeedRadPerS > 0) || curveSpeedRadPerS == Double.POSITIVE_INFINITY) {
      throw new IllegalArgumentException(
          "friction: curveSpeedRadPerS is " + curveSpeedRadPerS + " rad/s, must be above 0");
    }
  }

  private static boolean notNegative(double value) {
    return value >= 0 && value < Double.POSITIVE_INFINITY;
  }

  /**
   * The current that friction takes, A; exactly 0 at standstill.
   *
   * @param speedRadPerS of the joint, rad/s
   * @param loadNm moment on the joint without friction, Nm
   */
  public double currentA(double speedRadPerS, double loadNm) {
    return dryCurrentA(speedRadPerS, loadNm) + speedDependentA(speedRadPerS);
  }

  /** The first term of {@link #currentA}: dry friction on its way through standstill, A. */
  public double dryCurrentA(double speedRadPerS, double loadNm) {
    double x = speedRadPerS / TRANSITION_RAD_PER_S;
    return dryA(loadNm) * (Math.abs(x) < TANH_IS_ONE ? Math.tanh(x) : Math.signum(x));
  }

  /** Dry friction under a load (Nm), A. */
  public double dryA(double loadNm) {
    return coulombA + loadAPerNm * Math.abs(loadNm);
  }

  /** Speed-dependent friction: all but dry friction, A. */
  public double speedDependentA(double speedRadPerS) {
    return curvedA * Math.tanh(speedRadPerS / curveSpeedRadPerS) + viscousASPerRad * speedRadPerS;
  }

  /** {@link #speedDependentA} over the speed, A s/rad; at standstill its limit. */
  public double speedDependentASPerRad(double speedRadPerS) {
    double x = speedRadPerS / curveSpeedRadPerS;
    double share = Math.abs(x) < 1e-4 ? 1 : Math.tanh(x) / x;
    return curvedA / curveSpeedRadPerS * share + viscousASPerRad;
  }
}
