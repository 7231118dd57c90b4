package org.pendant.controller.device.gripper;

import static org.pendant.controller.device.gripper.GripperTexts.text;

import java.util.function.Consumer;

/** Driven fingers: those of a simple gripper, or a door, which a valve closes and opens. */
public final class DrivenFingers {
  private static final double FORCE_N = 100;

  private final Fingers fingers;
  private final double speedMPerS;
  private final String name;
  private final Consumer<String> tell;
  private boolean gripped;

  /**
   * Open ones.
   *
   * @param name that of their gripper, for what it tells
   * @param strokeM how far they open
   * @param timeS how long they take from end to end
   * @param tell is told what a user wants to know
   */
  public DrivenFingers(String name, double strokeM, double timeS, Consumer<String> tell) {
    fingers = new Fingers(strokeM);
    speedMPerS = strokeM / timeS;
    this.name = name;
    this.tell = tell;
  }

  /** What moves. */
  public Fingers fingers() {
    return fingers;
  }

  /** Whether they hold something. */
  public boolean gripped() {
    return gripped;
  }

  /** Moves them through one frame; driven both ways or none they go on as before. */
  public void step(boolean close, boolean open) {
    if (close != open) {
      fingers.drive(close ? 0 : fingers.strokeM(), speedMPerS, FORCE_N);
    }
    fingers.step();
    boolean now = fingers.pressing();
    if (now != gripped) {
      gripped = now;
      tell.accept(gripped ? AdaptiveGripper.gripping(name, fingers) : text("partLetGo", name));
    }
  }
}
