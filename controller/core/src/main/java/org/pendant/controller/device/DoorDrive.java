package org.pendant.controller.device;

import org.pendant.cell.BodyGuide;
import org.pendant.models.time.FrameTime;

/**
 * Door drive: takes the leaf of a door from end to end in its time. It speeds up and slows down
 * evenly, and holds where something is in the way that is stronger. Travel is in m where the leaf
 * slides and in rad where it turns; speeds are in the same a second.
 */
final class DoorDrive {
  /** Share of the time in which it speeds up, and of that in which it slows down. */
  private static final double RAMP = 0.15;

  /** This near an end it is left to its brake, as a share of the travel. */
  private static final double THERE = 1e-4;

  private final BodyGuide guide;
  private final double travel;
  private final double atEnd;
  private final double fastest;
  private final double acceleration;
  private double speed;

  DoorDrive(BodyGuide guide, DoorLeaf leaf, double timeS) {
    this.guide = guide;
    travel = leaf.travel();
    atEnd = leaf.atEnd();
    fastest = travel / ((1 - RAMP) * timeS);
    acceleration = fastest / (RAMP * timeS);
  }

  /** How far it is open: 1 where it was at first, 0 at the other end. */
  double openShare() {
    double place = guide.place();
    if (place <= atEnd) {
      return 1;
    }
    return place >= travel - atEnd ? 0 : 1 - place / travel;
  }

  /** Drives it through one frame, towards the end that is shut or back. */
  void step(boolean closes) {
    double left = closes ? travel - guide.place() : guide.place();
    if (left <= THERE * travel) {
      speed = 0;
      guide.drive(0);
      return;
    }
    double toward = closes ? speed : -speed;
    double next =
        Math.min(
            Math.min(fastest, Math.max(0, toward) + acceleration * FrameTime.FRAME_S),
            Math.min(Math.sqrt(2 * acceleration * left), left / FrameTime.FRAME_S));
    speed = closes ? next : -next;
    guide.drive(speed);
  }
}
