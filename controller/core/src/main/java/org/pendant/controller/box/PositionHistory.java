package org.pendant.controller.box;

import java.util.Arrays;
import org.pendant.models.arm.Joints;

/** Position history: where the joints were in the last frames (manual 16.5). */
public final class PositionHistory {
  /** Frames that are kept, the present one included: two seconds. */
  public static final int FRAMES = 1000;

  private final Joints[] ring = new Joints[FRAMES];
  private int newest;

  PositionHistory(Joints start) {
    Arrays.fill(ring, start);
  }

  void add(Joints positionRad) {
    newest = (newest + 1) % FRAMES;
    ring[newest] = positionRad;
  }

  /**
   * The actual joint positions {@code frames} ago, rad.
   *
   * @param frames 0 for the newest, below {@link #FRAMES}
   */
  public Joints ago(int frames) {
    return ring[Math.floorMod(newest - frames, FRAMES)];
  }
}
