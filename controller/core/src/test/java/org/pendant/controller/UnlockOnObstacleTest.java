package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.script.vm.ProgramState;

/** An arm that an obstacle has stopped, and an operator unlocks. */
final class UnlockOnObstacleTest {
  /** Frames of the 5 s that a protective stop lasts at least, and a little more. */
  private static final int UNLOCK_FRAMES = 2600;

  private final PressingArm arm = PressingArm.overTable(0.1);

  private SafetyMode safetyMode() {
    return arm.running.state().safety().safetyMode();
  }

  private double heightM() {
    return arm.arm().actualTcpInBase().z();
  }

  /** Presses on the table until it is stopped, and unlocks it; where it is then. */
  private double unlockedAtM() {
    arm.start("speedl([0, 0, -0.05, 0, 0, 0], 0.5, 60)\n");
    for (int i = 0; i < 5000 && safetyMode() == SafetyMode.NORMAL; i++) {
      arm.frames(1);
    }
    assertEquals(SafetyMode.PROTECTIVE_STOP, safetyMode());
    arm.frames(UNLOCK_FRAMES);
    double stoppedM = heightM();
    assertTrue(stoppedM > arm.target().z() + 2e-4, () -> stoppedM + " m, not held up");
    arm.running.done(new SafetyCommand.UnlockProtectiveStop(false));
    return stoppedM;
  }

  @Test
  void theArmPressesNoHarderWhileTheProgramIsPaused() {
    double stoppedM = unlockedAtM();
    arm.frames(5000);
    assertEquals(ProgramState.PAUSED, arm.running.programState());
    assertEquals(SafetyMode.NORMAL, safetyMode());
    assertEquals(stoppedM, heightM(), 1e-4);
  }
}
