package org.pendant.controller.box;

import org.pendant.models.arm.Joints;

/** Position history: where the joints were in the last frames (manual 16.5). */
public final class PositionHistory {
  /** Frames that are kept, the present one included: two seconds. */
  public static final int FRAMES = 1000;

  /** Six numbers a frame. */
  private final double[] ring = new double[FRAMES * Joints.COUNT];

  private int newest;

  PositionHistory(Joints start) {
    double[] startRad = start.toArray();
    for (int i = 0; i < FRAMES; i++) {
      add(startRad);
    }
  }

  void add(double[] positionRad) {
    newest = (newest + 1) % FRAMES;
    System.arraycopy(positionRad, 0, ring, newest * Joints.COUNT, Joints.COUNT);
  }

  /**
   * The actual joint positions {@code frames} ago, rad.
   *
   * @param frames 0 for the newest, below {@link #FRAMES}
   */
  public Joints ago(int frames) {
    int from = Math.floorMod(newest - frames, FRAMES) * Joints.COUNT;
    return new Joints(
        ring[from], ring[from + 1], ring[from + 2], ring[from + 3], ring[from + 4], ring[from + 5]);
  }
}
