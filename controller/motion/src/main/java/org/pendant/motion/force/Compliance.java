package org.pendant.motion.force;

import java.util.Arrays;
import org.pendant.models.time.FrameTime;

/**
 * Admittance: how fast the TCP gives way along a compliant axis: as a mass does that is pushed by
 * the wanted wrench, by what the tool feels, and by friction. Where the tool rests the two wrenches
 * are equal and opposite.
 *
 * <p>What the tool feels counts as it will be a moment later if it continues to change as it does,
 * which brakes a tool that meets a hard surface. A small gain makes that moment longer, so that the
 * brake is as strong as with a large one; a stronger one makes a tool on the stiffest surfaces
 * swing. A tool that presses too hard takes that back slowly, but one that has come down much too
 * hard gives way as something lighter, so that the impact is short.
 */
final class Compliance {
  /** Damping before a program sets it (manual 15.16). */
  static final double DEFAULT_DAMPING = 0.005;

  /** Gain scaling before a program sets it (manual 15.17). */
  static final double DEFAULT_GAIN = 1;

  /**
   * What the TCP seems to weigh, kg: recorded tools that nothing holds gain 0.013 to 0.02 m/s² for
   * each newton at a gain of 1.
   */
  private static final double MASS_KG = 56;

  /** How far ahead the felt wrench counts at a gain of 1, s: recorded tools settle so. */
  private static final double AHEAD_S = 0.15;

  /** With a smaller gain than this the brake gets weaker as well, and with none there is none. */
  private static final double MIN_FULL_GAIN = 0.5;

  /** How much of the force beyond the wanted one counts: recorded tools take it back slowly. */
  private static final double TOO_HARD_SHARE = 0.65;

  /** Pressed harder than wanted by more than this it gives way as something lighter, N. */
  private static final double MUCH_TOO_HARD_N = 60;

  /** What the TCP seems to weigh for the force beyond that, kg; our choice. */
  private static final double LIGHT_MASS_KG = 3;

  /** Radius of gyration about the TCP, m: a rotation is as a mass there; our choice. */
  private static final double GYRATION_M = 0.2236;

  /** How an axis that is not compliant takes back what is too far, 1/s. */
  private static final double RETURN_PER_S = 5;

  /** The fastest that it does so, m/s and rad/s. */
  private static final double RETURN_SPEED = 0.1;

  private final double[] deviation = new double[ForceTask.AXES];
  private double damping = DEFAULT_DAMPING;
  private double gain = DEFAULT_GAIN;

  /** How far ahead the felt wrench counts, times the gain, s. */
  private double aheadS = AHEAD_S;

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
    aheadS = AHEAD_S * Math.min(1, scaling / MIN_FULL_GAIN);
  }

  /**
   * The next velocity of what is carried.
   *
   * @param felt what acts on the tool
   * @param pathTwist6 how the path moves the TCP, m/s and rad/s along the axes of the base
   * @param twist6 the velocity so far, along the axes of the base
   * @param next6 overwritten
   */
  void step(
      ForceTask task,
      TaskAxes axes,
      FeltWrench felt,
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
        double acceleration =
            acceleration(
                axis.wrench(),
                axes.along(i % 3, felt.wrench(), from),
                axes.along(i % 3, felt.rate(), from),
                i < 3 ? 1 : GYRATION_M);
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

  /**
   * How the TCP speeds up along an axis, m/s², or about it, rad/s².
   *
   * @param wanted N or Nm
   * @param felt the same
   * @param feltPerS how fast that changes
   * @param armM the arm at which a force makes the wrench; 1 for a force itself
   */
  private double acceleration(double wanted, double felt, double feltPerS, double armM) {
    double forceN = (wanted + felt) / armM;
    boolean tooHard = wanted * felt <= 0 && forceN * felt > 0;
    double lightN = tooHard ? forceN - Math.clamp(forceN, -MUCH_TOO_HARD_N, MUCH_TOO_HARD_N) : 0;
    double share = tooHard ? TOO_HARD_SHARE : 1;
    double heavyN = gain * share * forceN + aheadS * feltPerS / armM;
    return (heavyN / MASS_KG + gain * lightN / LIGHT_MASS_KG) / armM;
  }
}
