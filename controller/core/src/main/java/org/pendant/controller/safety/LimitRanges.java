package org.pendant.controller.safety;

import org.pendant.models.json.Range;

/** Limit ranges: what the numbers of a set of limits may be in files, whatever the arm. */
public final class LimitRanges {
  public static final Range POWER = new Range(1, 10_000, "W");
  public static final Range MOMENTUM = new Range(0.1, 1000, "kg m/s");
  public static final Range STOPPING_TIME = new Range(0.01, 10, "s");
  public static final Range STOPPING_DISTANCE = new Range(0.01, 10, "m");

  /** Of the tool and of the elbow. */
  public static final Range SPEED = new Range(0.01, 20, "m/s");

  /** At the tool and at the elbow. */
  public static final Range FORCE = new Range(1, 10_000, "N");

  public static final Range JOINT_SPEED = new Range(0.01, 20, "rad/s");
  static final Range JOINT_POSITION = new Range(-1000, 1000, "rad");

  private LimitRanges() {}
}
