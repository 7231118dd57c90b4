package org.pendant.motion.force;

import java.util.Arrays;
import org.pendant.models.time.FrameTime;

/**
 * Admittance: how fast the TCP gives way along a compliant axis: as a mass does that is pushed by
 * the wanted wrench, by what the tool feels, and by friction. Where the tool rests the two wrenches
 * are equal and opposite.
 */
final class Compliance {
  /** Damping before a program sets it (manual 15.16). */
  static final double DEFAULT_DAMPING = 0.005;

  /** Gain scaling before a program sets it (manual 15.17). */
  static final double DEFAULT_GAIN = 1;

  /** What the TCP seems to weigh, kg and kg m²; not published, our choice. */
  private static final double MASS_KG = 10;

  private static final double INERTIA_KG_M2 = 0.5;

  /** How an axis that is not compliant takes back what is too far, 1/s. */
  private static final double RETURN_PER_S = 5;

  /** The fastest that it does so, m/s and rad/s. */
  private static final double RETURN_SPEED = 0.1;

  private final double[] deviation = new double[ForceTask.AXES];
  private double damping = DEFAULT_DAMPING;
  private double gain = DEFAULT_GAIN;

  double damping() {
    return damping;
  }

  void setDamping(double share) {
    damping = share;
  }

  double gain() {
    return gain;
  }

  void setGain(double scaling) {
    gain = scaling;
  }

  /**
   * The next velocity of what is carried.
   *
   * @param felt6 wrench on the tool about the TCP, along the axes of the base
   * @param pathTwist6 how the path moves the TCP, m/s and rad/s along the axes of the base
   * @param twist6 the velocity so far, along the axes of the base
   * @param next6 overwritten
   */
  void step(
      ForceTask task,
      TaskAxes axes,
      double[] felt6,
      double[] pathTwist6,
      ComplianceOffset complianceOffset,
      double[] twist6,
      double[] next6) {
    Arrays.fill(next6, 0);
    if (!axes.known()) {
      return;
    }
    complianceOffset.measure(axes, deviation);
    for (int i = 0; i < ForceTask.AXES; i++) {
      int from = i < 3 ? 0 : 3;
      ForceAxis axis = task.axes().get(i);
      double speed;
      if (axis.compliant()) {
        double wrench = axis.wrench() + axes.along(i % 3, felt6, from);
        double acceleration = gain * wrench / (i < 3 ? MASS_KG : INERTIA_KG_M2);
        double path = axes.along(i % 3, pathTwist6, from);
        speed =
            Math.clamp(
                (1 - damping) * axes.along(i % 3, twist6, from) + acceleration * FrameTime.FRAME_S,
                -axis.limit() - path,
                axis.limit() - path);
      } else {
        double beyond = deviation[i] - Math.clamp(deviation[i], -axis.limit(), axis.limit());
        speed = Math.clamp(-RETURN_PER_S * beyond, -RETURN_SPEED, RETURN_SPEED);
      }
      axes.add(i % 3, speed, next6, from);
    }
  }
}
