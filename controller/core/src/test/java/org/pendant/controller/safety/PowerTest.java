package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Refusal;

final class PowerTest {
  private final SafetyBench bench = SafetyBench.off();
  private final SafetySystem safety = bench.safety;

  private List<RobotMode> modesDuring(int frames) {
    List<RobotMode> modes = new ArrayList<>();
    for (int i = 0; i < frames; i++) {
      bench.step();
      if (modes.isEmpty() || modes.getLast() != safety.robotMode()) {
        modes.add(safety.robotMode());
      }
    }
    return modes;
  }

  @Test
  void armIsOffUntilAsked() {
    assertEquals(List.of(RobotMode.POWER_OFF), modesDuring(2000));
    assertEquals(SafetyMode.NORMAL, safety.safetyMode());
  }

  @Test
  void powerOnLeadsToIdleWithinTwoSeconds() {
    assertEquals(Optional.empty(), safety.powerOn());
    assertEquals(List.of(RobotMode.BOOTING, RobotMode.POWER_ON, RobotMode.IDLE), modesDuring(1000));
    assertEquals(List.of(RobotMode.IDLE), modesDuring(2000));
  }

  @Test
  void powerOnAgainChangesNothing() {
    safety.powerOn();
    bench.steps(100);
    assertEquals(Optional.empty(), safety.powerOn());
    bench.steps(700);
    assertEquals(RobotMode.IDLE, safety.robotMode());
    assertEquals(Optional.empty(), safety.powerOn());
    bench.step();
    assertEquals(RobotMode.IDLE, safety.robotMode());
  }

  @Test
  void brakesTakeASecond() {
    safety.powerOn();
    bench.steps(1000);
    assertEquals(Optional.empty(), safety.releaseBrakes());
    bench.steps(499);
    assertEquals(RobotMode.IDLE, safety.robotMode());
    bench.step();
    assertEquals(RobotMode.RUNNING, safety.robotMode());
  }

  @Test
  void brakesOfAnArmThatIsOffAreReleasedAfterPoweringOn() {
    safety.releaseBrakes();
    assertEquals(
        List.of(RobotMode.BOOTING, RobotMode.POWER_ON, RobotMode.IDLE, RobotMode.RUNNING),
        modesDuring(1500));
  }

  @Test
  void powerOffCutsAtOnce() {
    safety.releaseBrakes();
    bench.steps(1500);
    safety.powerOff();
    assertEquals(RobotMode.POWER_OFF, safety.robotMode());
    assertEquals(List.of(RobotMode.POWER_OFF), modesDuring(2000));
  }

  @Test
  void programNeedsARunningArm() {
    assertEquals(
        Optional.of(
            "the arm is POWER_OFF, must be RUNNING: power it on and release its brakes first"),
        safety.programRefusal().map(Refusal::text));
    safety.releaseBrakes();
    bench.steps(1500);
    assertEquals(Optional.empty(), safety.programRefusal());
  }

  @Test
  void backdriveStartsAndEndsOnTheBrakes() {
    assertEquals(
        Optional.of("the arm is POWER_OFF, must be IDLE for backdrive"),
        safety.startBackdrive().map(Refusal::text));
    assertEquals(
        Optional.of("the arm is POWER_OFF, must be in BACKDRIVE"),
        safety.endBackdrive().map(Refusal::text));
    safety.powerOn();
    bench.steps(1000);
    assertEquals(Optional.empty(), safety.startBackdrive());
    assertEquals(RobotMode.BACKDRIVE, safety.robotMode());
    assertEquals(
        Optional.of("the arm is in BACKDRIVE, which must be ended first"),
        safety.releaseBrakes().map(Refusal::text));
    bench.steps(1000);
    assertEquals(Optional.empty(), safety.endBackdrive());
    assertEquals(RobotMode.IDLE, safety.robotMode());
  }

  @Test
  void jointsReportThePowerStep() {
    assertEquals(239, safety.jointMode(0).code());
    safety.releaseBrakes();
    bench.step();
    assertEquals(247, safety.jointMode(3).code());
    bench.steps(850);
    assertEquals(255, safety.jointMode(5).code());
    bench.steps(600);
    assertEquals(253, safety.jointMode(5).code());
  }

  @Test
  void jointsReportBackdrive() {
    safety.powerOn();
    bench.steps(1000);
    safety.startBackdrive();
    assertEquals(238, safety.jointMode(1).code());
  }

  @Test
  void emergencyStopKeepsTheArmOff() {
    safety.setInput(SafetyInput.EMERGENCY_STOP, true);
    bench.step();
    Optional<String> refusal =
        Optional.of("input emergency_stop is active, must be released first");
    assertEquals(refusal, safety.powerOn().map(Refusal::text));
    assertEquals(refusal, safety.releaseBrakes().map(Refusal::text));
    safety.setInput(SafetyInput.EMERGENCY_STOP, false);
    bench.step();
    assertEquals(Optional.empty(), safety.powerOn());
    assertTrue(safety.stop().isEmpty());
  }
}
