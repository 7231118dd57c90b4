package org.pendant.controller.box;

import java.util.Set;
import org.pendant.models.arm.ArmDescription;

/**
 * Motion settings: how moves are planned; they last from one program to the next (manual 14.1,
 * 15.25).
 *
 * <p>Version 1 changes speeds by even acceleration and leaves out moves whose blends overlap.
 * Version 2 limits the jerk and makes such blends smaller.
 */
public final class MotionSettings {
  /** Smallest share of the usual jerk. */
  public static final double MIN_JERK_GAIN = 0.01;

  /**
   * How long the acceleration takes to grow to its limit with the usual jerk, s. Our choice: the
   * manual says only that the usual jerk depends on pose, payload and acceleration.
   */
  private static final double JERK_RAMP_S = 0.08;

  /** Newer than what has both versions (manual 14.2). */
  private static final Set<String> ONLY_VERSION_2 = Set.of("ur15", "ur18", "ur8long");

  private final boolean newOnly;
  private int version;
  private double jerkGain = 1;

  /** Settings of a box that was just switched on: version 1 where the arm has it. */
  public MotionSettings(ArmDescription arm) {
    newOnly = ONLY_VERSION_2.contains(arm.id());
    version = newOnly ? 2 : 1;
  }

  /** The motion version, 1 or 2. */
  public int version() {
    return version;
  }

  /**
   * Changes the version.
   *
   * @param wanted 1 or 2
   * @return whether the arm has it; nothing has changed if not
   */
  public boolean setVersion(int wanted) {
    if (wanted < (newOnly ? 2 : 1) || wanted > 2) {
      return false;
    }
    version = wanted;
    return true;
  }

  /** The share of the usual jerk that moves may have. */
  public double jerkGain() {
    return jerkGain;
  }

  /**
   * Changes the share of the usual jerk.
   *
   * @param gain {@value #MIN_JERK_GAIN} to 1
   */
  public void setJerkGain(double gain) {
    jerkGain = gain;
  }

  /** How long acceleration takes to grow to its limit in movej and movel, s; 0 for at once. */
  public double jerkRampS() {
    return version == 2 ? smoothRampS() : 0;
  }

  /** The same for moves that always limit the jerk, s. */
  public double smoothRampS() {
    return JERK_RAMP_S / jerkGain;
  }
}
