package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Refusal;
import org.pendant.models.arm.Joints;

final class InputStopTest {
  private static final Joints SLOW = SafetyBench.speed(0, 0.2);

  private final SafetyBench bench = SafetyBench.standard().program(true);
  private final SafetySystem safety = bench.safety;

  @Test
  void emergencyStopStopsOnThePathThenCutsThePower() {
    bench.target(SafetyBench.START, SLOW).step();
    safety.setInput(SafetyInput.EMERGENCY_STOP, true);
    assertEquals(SafetyAction.STOP_ON_PATH_THEN_OFF, bench.step());
    assertEquals(SafetyMode.ROBOT_EMERGENCY_STOP, safety.safetyMode());
    assertEquals(StopCategory.ONE, bench.stop().category());
    assertEquals(
        "C100A7 emergency stop at 0.004 s: input emergency_stop is active", bench.stop().message());
    assertEquals(15, safety.stopDecelerationRadPerS2());
    bench.step();
    assertEquals(RobotMode.RUNNING, safety.robotMode());
    bench.target(SafetyBench.START, Joints.ZERO).step();
    assertEquals(RobotMode.POWER_OFF, safety.robotMode());
    assertEquals(SafetyMode.ROBOT_EMERGENCY_STOP, safety.safetyMode());
  }

  @Test
  void emergencyStopCutsThePowerAfterHalfASecondWhateverTheTargetDoes() {
    bench.target(SafetyBench.START, SLOW).step();
    safety.setInput(SafetyInput.SYSTEM_EMERGENCY_STOP, true);
    bench.step();
    assertEquals(SafetyMode.SYSTEM_EMERGENCY_STOP, safety.safetyMode());
    bench.steps(249);
    assertEquals(RobotMode.RUNNING, safety.robotMode());
    bench.step();
    assertEquals(RobotMode.POWER_OFF, safety.robotMode());
  }

  @Test
  void releasedEmergencyStopStillCutsThePower() {
    bench.target(SafetyBench.START, SLOW).step();
    safety.setInput(SafetyInput.EMERGENCY_STOP, true);
    bench.step();
    safety.setInput(SafetyInput.EMERGENCY_STOP, false);
    bench.step();
    assertEquals(SafetyMode.ROBOT_EMERGENCY_STOP, safety.safetyMode());
    bench.steps(300);
    assertEquals(SafetyMode.NORMAL, safety.safetyMode());
    assertEquals(RobotMode.POWER_OFF, safety.robotMode());
  }

  @Test
  void emergencyStopRefusesPrograms() {
    safety.setInput(SafetyInput.EMERGENCY_STOP, true);
    bench.step();
    assertEquals(
        Optional.of(
            "C100A7 emergency stop at 0.002 s: input emergency_stop is active;"
                + " release the input, then power the arm on"),
        safety.programRefusal().map(Refusal::text));
  }

  @Test
  void safeguardStopHoldsTheProgramUntilTheInputIsGone() {
    safety.setInput(SafetyInput.SAFEGUARD_STOP, true);
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(SafetyMode.SAFEGUARD_STOP, safety.safetyMode());
    assertEquals(StopCategory.TWO, bench.stop().category());
    bench.program(false).steps(1000);
    assertEquals(RobotMode.RUNNING, safety.robotMode());
    assertTrue(
        safety.programRefusal().orElseThrow().text().endsWith("wait until the input is released"));
    safety.setInput(SafetyInput.SAFEGUARD_STOP, false);
    assertEquals(SafetyAction.RESUME, bench.step());
    assertEquals(SafetyAction.NONE, bench.step());
    assertEquals(SafetyMode.NORMAL, safety.safetyMode());
  }

  @Test
  void safeguardStopWithoutAProgramResumesNothing() {
    bench.program(false);
    safety.setInput(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP, true);
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(SafetyMode.AUTOMATIC_MODE_SAFEGUARD_STOP, safety.safetyMode());
    safety.setInput(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP, false);
    assertEquals(SafetyAction.NONE, bench.step());
    assertTrue(safety.stop().isEmpty());
  }

  @Test
  void safeguardStopLastsUntilBothInputsAreGone() {
    safety.setInput(SafetyInput.SAFEGUARD_STOP, true);
    bench.step();
    safety.setInput(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP, true);
    safety.setInput(SafetyInput.SAFEGUARD_STOP, false);
    assertEquals(SafetyAction.NONE, bench.step());
    assertTrue(safety.stop().isPresent());
    safety.setInput(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP, false);
    assertEquals(SafetyAction.RESUME, bench.step());
  }

  @Test
  void emergencyStopDuringASafeguardStopEndsTheProgram() {
    safety.setInput(SafetyInput.SAFEGUARD_STOP, true);
    bench.step();
    safety.setInput(SafetyInput.EMERGENCY_STOP, true);
    assertEquals(SafetyAction.STOP_ON_PATH_THEN_OFF, bench.step());
    safety.setInput(SafetyInput.SAFEGUARD_STOP, false);
    safety.setInput(SafetyInput.EMERGENCY_STOP, false);
    for (int i = 0; i < 400; i++) {
      assertEquals(SafetyAction.NONE, bench.step());
    }
    assertTrue(safety.stop().isEmpty());
  }

  @Test
  void softTransitionsConcernSafeguardStopsOnly() {
    safety.setTransitionHardness(1);
    safety.setInput(SafetyInput.SAFEGUARD_STOP, true);
    bench.step();
    assertEquals(4, safety.stopDecelerationRadPerS2());
    safety.setInput(SafetyInput.EMERGENCY_STOP, true);
    bench.step();
    assertEquals(15, safety.stopDecelerationRadPerS2());
  }

  @Test
  void hardnessIsZeroOrOne() {
    assertEquals(
        "type is 2, must be 0 (hard) or 1 (soft)",
        assertThrows(IllegalArgumentException.class, () -> safety.setTransitionHardness(2))
            .getMessage());
  }

  @Test
  void inputsAreRemembered() {
    assertFalse(safety.active(SafetyInput.REDUCED_MODE));
    safety.setInput(SafetyInput.REDUCED_MODE, true);
    assertTrue(safety.active(SafetyInput.REDUCED_MODE));
  }

  @Test
  void inputsHaveWords() {
    assertEquals(SafetyInput.SAFEGUARD_STOP, SafetyInput.named("safeguard_stop"));
    assertEquals(
        "safety input is 'reduced', must be one of emergency_stop, system_emergency_stop,"
            + " safeguard_stop, automatic_mode_safeguard_stop, reduced_mode",
        assertThrows(IllegalArgumentException.class, () -> SafetyInput.named("reduced"))
            .getMessage());
  }

  @Test
  void inManualModeTheSafeguardOfAutomaticModeDoesNotCount() {
    SafetyBench attended = SafetyBench.standard();
    attended.safety.setManualMode(true);
    attended.safety.setInput(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP, true);
    attended.steps(2);
    assertEquals(SafetyMode.NORMAL, attended.safety.safetyMode());
    attended.safety.setInput(SafetyInput.SAFEGUARD_STOP, true);
    attended.steps(2);
    assertEquals(SafetyMode.SAFEGUARD_STOP, attended.safety.safetyMode());
    attended.safety.setInput(SafetyInput.SAFEGUARD_STOP, false);
    attended.safety.setManualMode(false);
    attended.steps(2);
    assertTrue(attended.safety.stop().isPresent());
  }
}
