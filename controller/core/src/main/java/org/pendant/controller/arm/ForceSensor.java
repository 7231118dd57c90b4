package org.pendant.controller.arm;

import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Transforms;
import org.pendant.models.pose.Wrench;

/**
 * Force/torque sensor in the flange, rid of the declared payload and of its zero: what is left is
 * what pushes the tool from outside. A payload that is declared wrongly shows.
 *
 * <p>Force and torque are those <b>on</b> the tool: pressing down on a table reads a force upwards.
 * The zero is kept along the axes of the flange, as a sensor's offset is.
 *
 * <p>Belongs to the thread of the frame loop.
 */
public final class ForceSensor {
  private final double[] flange12 = new double[Transforms.SIZE];
  private Wrench zero = Wrench.ZERO;
  private Wrench felt = Wrench.ZERO;

  /**
   * Makes what {@code arm} feels now beyond the declared payload the zero (manual 18.72), without
   * the noise of this moment.
   */
  public void zero(SimulatedArm arm, Payload declared) {
    zero = less(arm.loadOnFlange(), arm.weightOf(declared));
  }

  /** The reading at the flange's origin, along the flange's axes. */
  public Wrench reading(SimulatedArm arm, Payload declared) {
    felt = less(arm.loadOnFlange(), arm.sensors().flangeNoise6);
    return less(felt, arm.weightOf(declared), zero);
  }

  /**
   * What the sensor felt for the latest {@link #reading}: with the weight of the payload and
   * without its zero, at the flange's origin along the flange's axes.
   */
  public Wrench felt() {
    return felt;
  }

  /** The reading at the flange's origin, along the axes of the base (manual 16.32). */
  public Wrench wrenchAtFlangeInBase(SimulatedArm arm, Payload declared) {
    arm.copyFlangeInBase(flange12);
    return alongBase(reading(arm, declared), flange12);
  }

  /** A wrench along the axes of the flange, along those of the base. */
  static Wrench alongBase(Wrench w, double[] flange12) {
    return new Wrench(
        alongBase(flange12, 0, w.fx(), w.fy(), w.fz()),
        alongBase(flange12, 1, w.fx(), w.fy(), w.fz()),
        alongBase(flange12, 2, w.fx(), w.fy(), w.fz()),
        alongBase(flange12, 0, w.mx(), w.my(), w.mz()),
        alongBase(flange12, 1, w.mx(), w.my(), w.mz()),
        alongBase(flange12, 2, w.mx(), w.my(), w.mz()));
  }

  private static double alongBase(double[] flange12, int axis, double x, double y, double z) {
    return flange12[3 * axis] * x + flange12[3 * axis + 1] * y + flange12[3 * axis + 2] * z;
  }

  static Wrench less(Wrench a, Wrench b) {
    return new Wrench(
        a.fx() - b.fx(),
        a.fy() - b.fy(),
        a.fz() - b.fz(),
        a.mx() - b.mx(),
        a.my() - b.my(),
        a.mz() - b.mz());
  }

  private static Wrench less(Wrench a, Wrench b, Wrench c) {
    return new Wrench(
        a.fx() - b.fx() - c.fx(),
        a.fy() - b.fy() - c.fy(),
        a.fz() - b.fz() - c.fz(),
        a.mx() - b.mx() - c.mx(),
        a.my() - b.my() - c.my(),
        a.mz() - b.mz() - c.mz());
  }

  private static Wrench less(Wrench a, double[] b6) {
    return new Wrench(
        a.fx() - b6[0],
        a.fy() - b6[1],
        a.fz() - b6[2],
        a.mx() - b6[3],
        a.my() - b6[4],
        a.mz() - b6[5]);
  }
}
