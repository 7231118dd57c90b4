package org.pendant.motion.offset;

import org.pendant.models.time.FrameTime;

/**
 * Catch-up law: follows a travel that may be running already or change suddenly: within a limited
 * acceleration the gap is closed as fast as possible, and from then on there is none.
 */
final class CatchUp {
  private static final double FRAME_S = FrameTime.FRAME_S;

  private double goal;
  private double travel;
  private double before;
  private double speed;

  /** Nothing has travelled; {@code speed} is that of what follows, per s. */
  void begin(double speedNow) {
    goal = 0;
    travel = 0;
    before = 0;
    speed = speedNow;
  }

  /** What follows has been brought to rest. */
  void rest() {
    speed = 0;
  }

  /**
   * A frame later.
   *
   * @param next where to be
   * @param acceleration per s²
   * @param closing how much faster than the goal, per s
   */
  void step(double next, double acceleration, double closing) {
    double goalSpeed = (next - goal) / FRAME_S;
    double change = acceleration * FRAME_S;
    double exact = (next - travel) / FRAME_S;
    before = travel;
    if (Math.abs(exact - speed) <= change && Math.abs(exact - goalSpeed) <= change) {
      travel = next;
      speed = exact;
    } else {
      double gap = goal - travel;
      double approach = Math.min(closing, approach(Math.abs(gap), acceleration));
      double wanted = goalSpeed + Math.signum(gap) * approach;
      speed = Math.max(speed - change, Math.min(speed + change, wanted));
      travel += speed * FRAME_S;
    }
    goal = next;
  }

  /** The speed from which frames of even slowing down end without a gap. */
  private static double approach(double gap, double acceleration) {
    double steps = 2 * gap / (acceleration * FRAME_S * FRAME_S);
    return acceleration * FRAME_S * (Math.sqrt(0.25 + steps) - 0.5);
  }

  /** Where it is. */
  double travel() {
    return travel;
  }

  /** Where it was a frame before. */
  double travelBefore() {
    return before;
  }

  /** How fast it goes, per s. */
  double speed() {
    return speed;
  }
}
