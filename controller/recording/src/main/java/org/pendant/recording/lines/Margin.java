package org.pendant.recording.lines;

/** Margin: a limit that the arm keeps clear of, and in what its distance is told. */
public enum Margin {
  /** Speed of a joint, as a share of what it can do; 1 is all of it. */
  JOINT_SPEED(0, "jointSpeed", true, 1, 0.5),
  /** Torque of a joint, as a share of what it can do; 1 is all of it. */
  TORQUE(1, "torque", true, 1, 0.5),
  /** Distance of a joint from the end of its range, rad. */
  JOINT_LIMIT(2, "jointLimit", false, 0, Math.toRadians(45)),
  /** Distance of the tool or the elbow from a safety plane, m. */
  PLANE(3, "safetyPlane", false, 0, 0.2),
  /** Speed of the tool, as a share of the safety limit; 1 is all of it. */
  TOOL_SPEED(4, "toolSpeed", true, 1, 0.5);

  private final int index;
  private final String key;
  private final boolean share;
  private final double tight;
  private final double ample;

  Margin(int index, String key, boolean share, double tight, double ample) {
    this.index = index;
    this.key = key;
    this.share = share;
    this.tight = tight;
    this.ample = ample;
  }

  /** Its place in tables, from 0. */
  public int index() {
    return index;
  }

  /** Its name in a sentence. */
  public String words() {
    return LinesTexts.text(key);
  }

  /** The value from which on there is ample room. */
  public double ample() {
    return ample;
  }

  /** Whether its values are shares of a limit; distances otherwise. */
  public boolean isShare() {
    return share;
  }

  /** Whether a value is nearer to the limit than another one. */
  boolean nearer(double value, double other) {
    return share ? value > other : value < other;
  }

  /** The value that every other one is nearer than. */
  double farthest() {
    return share ? 0 : Double.POSITIVE_INFINITY;
  }

  /** How much of the margin is used up: 0 with ample room, 1 at the limit and beyond. */
  public double used(double value) {
    double used = (value - ample) / (tight - ample);
    return used > 0 ? Math.min(1, used) : 0;
  }

  /** The value at which so much of the margin, 0 to 1, is used up; at 0 the one with ample room. */
  public double valueAt(double used) {
    return ample + used * (tight - ample);
  }
}
