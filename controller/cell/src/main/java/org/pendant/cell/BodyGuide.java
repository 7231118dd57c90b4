package org.pendant.cell;

/**
 * Body guide: leaves a free body one way to move, between two ends, against friction. With {@link
 * #drive} that friction becomes a motor.
 */
public abstract sealed class BodyGuide permits BodyRail, BodyHinge {
  /** Share of how far the body is off its line that one step takes back. */
  static final double RECOVERY = 0.2;

  final CellBody body;

  /** At which its friction takes the body along, m/s or rad/s. */
  double driven;

  BodyGuide(CellBody body) {
    this.body = body;
  }

  /** How far the body is from where it was at first: m along a rail, rad about a hinge. */
  public abstract double place();

  /**
   * Has its friction take the body along from now on: a motor that is as strong as that, and a
   * brake at speed 0.
   *
   * @param speed m/s or rad/s, towards the far end where it is above 0
   */
  public final void drive(double speed) {
    if (speed != 0) {
      body.wake();
    }
    driven = speed;
  }

  /** Whether its body moves. */
  final boolean active() {
    return body.awake && body.present;
  }

  /** Begins a step: how far the body is off, and how fast it may go. */
  abstract void begin(double stepS);

  /** Corrects the impulses; answers by how much, Ns. */
  abstract double solve();

  /** The least speed away from an end that is so far beyond the body, m/s or rad/s. */
  static double toEnd(double beyond, double stepS) {
    return (beyond > 0 ? RECOVERY : 1) * beyond / stepS;
  }
}
