package org.pendant.controller.arm;

import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Transforms;
import org.pendant.models.pose.Wrench;

/**
 * External force/torque sensor between flange and tool, whose readings are sent from outside
 * (manual 18.2). It takes the place of the one in the flange where forces are controlled.
 *
 * <p>The declared payload includes the sensor, which feels all of it but itself. What is left of a
 * reading is what pushes the tool from outside.
 *
 * <p>Belongs to the thread of the frame loop.
 */
public final class ExternalForceSensor {
  private final double[] flange12 = new double[Transforms.SIZE];
  private boolean enabled;
  private Attachment mounting = new Attachment(Payload.NONE, 0, 0, 0);
  private Wrench reading = Wrench.ZERO;

  /**
   * How the sensor is mounted.
   *
   * @param sensor the sensor itself, in the flange frame
   * @param xM where it measures, in the flange frame, m
   * @param yM along y, m
   * @param zM along z, m
   */
  public record Attachment(Payload sensor, double xM, double yM, double zM) {}

  /** Readings count from now on; until one comes the last one does. */
  public void enable(Attachment mounting) {
    this.mounting = mounting;
    enabled = true;
  }

  /** Readings no longer count. */
  public void disable() {
    enabled = false;
  }

  /** Whether readings count. */
  public boolean enabled() {
    return enabled;
  }

  /**
   * What the sensor reads now.
   *
   * @param wrench on the tool at the point where it measures, N and Nm along the axes of the flange
   */
  public void read(Wrench wrench) {
    reading = wrench;
  }

  /** The external wrench at the flange's origin, along the axes of the base. */
  public Wrench wrenchAtFlangeInBase(SimulatedArm arm, Payload declared) {
    Wrench r = reading;
    Wrench atFlange =
        new Wrench(
            r.fx(),
            r.fy(),
            r.fz(),
            r.mx() + mounting.yM() * r.fz() - mounting.zM() * r.fy(),
            r.my() + mounting.zM() * r.fx() - mounting.xM() * r.fz(),
            r.mz() + mounting.xM() * r.fy() - mounting.yM() * r.fx());
    Wrench carried = ForceSensor.less(arm.weightOf(declared), arm.weightOf(mounting.sensor()));
    arm.copyFlangeInBase(flange12);
    return ForceSensor.alongBase(ForceSensor.less(atFlange, carried), flange12);
  }
}
