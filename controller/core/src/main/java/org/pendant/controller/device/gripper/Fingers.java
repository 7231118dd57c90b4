package org.pendant.controller.device.gripper;

import org.pendant.models.time.FrameTime;

/**
 * Fingers of a gripper: two that move towards each other along a line. They go to an opening at a
 * steady speed and press with a force on what they meet. The frame loop owns them.
 */
public final class Fingers {
  private final double strokeM;
  private FingerSpace space = FingerSpace.FREE;
  private FingerSpace around = FingerSpace.FREE;
  private double openingM;
  private double targetM;
  private double speedMPerS;
  private double forceN;
  private int direction;
  private int pressedFrames;

  /**
   * Fingers that are fully open and at rest.
   *
   * @param strokeM how far they open
   */
  Fingers(double strokeM) {
    this.strokeM = strokeM;
    openingM = strokeM;
    targetM = strokeM;
  }

  /** How far they open, m. */
  public double strokeM() {
    return strokeM;
  }

  /** How far they are open, m. */
  public double openingM() {
    return openingM;
  }

  /** Whether they move, or would if nothing were in their way: 1 opens, -1 closes, 0 at rest. */
  public int direction() {
    return direction;
  }

  /** Whether they press on something. */
  public boolean pressing() {
    return pressedFrames > 0;
  }

  /** For how long they have pressed on something, s. */
  public double pressedS() {
    return pressedFrames * FrameTime.FRAME_S;
  }

  /** How hard they press, N; 0 where they touch nothing. */
  public double pressN() {
    return pressing() ? forceN : 0;
  }

  /** How wide the part is that was put between them, m; 0 where there is none of a set width. */
  public double partWidthM() {
    return space instanceof PartBetween part ? part.widthM() : 0;
  }

  /** From now on this is in their way; for {@link FingerSpace#FREE} what they are among. */
  public void put(FingerSpace between) {
    space = between.equals(FingerSpace.FREE) ? around : between;
  }

  /** They are among bodies of the cell, which are in their way where nothing else was put. */
  public void among(FingerSpace bodies) {
    if (space.equals(around)) {
      space = bodies;
    }
    around = bodies;
  }

  /**
   * Begins to move.
   *
   * @param toM opening, taken to the nearest that there is
   * @param atMPerS how fast, above 0
   * @param withN how hard they press on what they meet
   */
  void drive(double toM, double atMPerS, double withN) {
    targetM = Math.clamp(toM, 0, strokeM);
    speedMPerS = atMPerS;
    forceN = withN;
    int wanted = Double.compare(targetM, openingM);
    if (wanted != direction) {
      pressedFrames = 0;
    }
    direction = wanted;
  }

  /** Stops them where they are. */
  void stop() {
    direction = 0;
    pressedFrames = 0;
  }

  /** Moves them through one frame. */
  void step() {
    if (direction != 0) {
      move(speedMPerS * FrameTime.FRAME_S);
    }
    space.press(openingM, pressN());
    if (!space.equals(around)) {
      around.press(openingM, 0);
    }
  }

  private void move(double wayM) {
    double wanted =
        direction < 0 ? Math.max(targetM, openingM - wayM) : Math.min(targetM, openingM + wayM);
    double reached =
        direction < 0
            ? Math.max(wanted, space.closesToM(openingM, forceN))
            : Math.min(wanted, space.opensToM(openingM, forceN));
    openingM = reached;
    if (reached != wanted) {
      pressedFrames++;
    } else {
      pressedFrames = 0;
      direction = Double.compare(targetM, openingM);
    }
  }
}
