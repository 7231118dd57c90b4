package org.pendant.controller.arm;

import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Transforms;
import org.pendant.models.pose.Wrench;
import org.pendant.models.pose.WrenchNumbers;

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

  /** What is felt, and then what is read, along the axes of the flange. */
  private final double[] own6 = new double[6];

  private final double[] weight6 = new double[6];
  private Wrench zero = Wrench.ZERO;
  private final WrenchNumbers felt = new WrenchNumbers();

  /**
   * Makes what {@code arm} feels now beyond the declared payload the zero (manual 18.72), without
   * the noise of this moment.
   */
  public void zero(SimulatedArm arm, Payload declared) {
    zero = less(arm.loadOnFlange(), arm.weightOf(declared));
  }

  /** The reading at the flange's origin, along the flange's axes. */
  public Wrench reading(SimulatedArm arm, Payload declared) {
    read(arm, declared);
    return new Wrench(own6[0], own6[1], own6[2], own6[3], own6[4], own6[5]);
  }

  private void read(SimulatedArm arm, Payload declared) {
    arm.copyLoadOnFlange(own6);
    double[] noise6 = arm.sensors().flangeNoise6;
    felt.set(
        own6[0] - noise6[0],
        own6[1] - noise6[1],
        own6[2] - noise6[2],
        own6[3] - noise6[3],
        own6[4] - noise6[4],
        own6[5] - noise6[5]);
    arm.copyWeightOf(declared, weight6);
    own6[0] = felt.get(0) - weight6[0] - zero.fx();
    own6[1] = felt.get(1) - weight6[1] - zero.fy();
    own6[2] = felt.get(2) - weight6[2] - zero.fz();
    own6[3] = felt.get(3) - weight6[3] - zero.mx();
    own6[4] = felt.get(4) - weight6[4] - zero.my();
    own6[5] = felt.get(5) - weight6[5] - zero.mz();
  }

  /**
   * What the sensor felt for the latest {@link #reading}: with the weight of the payload and
   * without its zero, at the flange's origin along the flange's axes; changes with the next one.
   */
  public WrenchNumbers felt() {
    return felt;
  }

  /** Writes the reading at the flange's origin, along the axes of the base (manual 16.32). */
  public void readAtFlangeInBase(SimulatedArm arm, Payload declared, WrenchNumbers wrench) {
    arm.copyFlangeInBase(flange12);
    read(arm, declared);
    alongBase(own6, flange12, wrench);
  }

  /** A wrench along the axes of the flange, along those of the base. */
  static Wrench alongBase(Wrench w, double[] flange12) {
    WrenchNumbers turned = new WrenchNumbers();
    alongBase(new double[] {w.fx(), w.fy(), w.fz(), w.mx(), w.my(), w.mz()}, flange12, turned);
    return turned.wrench();
  }

  private static void alongBase(double[] w6, double[] flange12, WrenchNumbers turned) {
    turned.set(
        alongBase(flange12, 0, w6[0], w6[1], w6[2]),
        alongBase(flange12, 1, w6[0], w6[1], w6[2]),
        alongBase(flange12, 2, w6[0], w6[1], w6[2]),
        alongBase(flange12, 0, w6[3], w6[4], w6[5]),
        alongBase(flange12, 1, w6[3], w6[4], w6[5]),
        alongBase(flange12, 2, w6[3], w6[4], w6[5]));
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
}
