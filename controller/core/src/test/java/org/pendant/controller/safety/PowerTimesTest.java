package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Refusal;

final class PowerTimesTest {
  private static final int UNLOCK_FRAMES = 2600;

  private static List<RobotMode> modesDuring(SafetyBench bench, int frames) {
    List<RobotMode> modes = new ArrayList<>();
    for (int i = 0; i < frames; i++) {
      bench.step();
      if (modes.isEmpty() || modes.getLast() != bench.safety.robotMode()) {
        modes.add(bench.safety.robotMode());
      }
    }
    return modes;
  }

  @Test
  void powerGoesOffAfterItsTime() {
    SafetyBench bench = new SafetyBench(PowerTimes.REAL);
    bench.step();
    bench.safety.powerOff();
    assertEquals(List.of(RobotMode.RUNNING), modesDuring(bench, 49));
    assertEquals(List.of(RobotMode.POWER_OFF), modesDuring(bench, 1000));
  }

  @Test
  void noProgramStartsWhilePowerGoesOff() {
    SafetyBench bench = new SafetyBench(PowerTimes.REAL);
    bench.safety.powerOff();
    assertEquals(
        Optional.of("the arm is being powered off"),
        bench.safety.programRefusal().map(Refusal::text));
  }

  @Test
  void askingAgainDoesNotPutItOff() {
    SafetyBench bench = new SafetyBench(PowerTimes.REAL);
    bench.safety.powerOff();
    bench.steps(30);
    bench.safety.powerOff();
    bench.steps(20);
    assertEquals(RobotMode.POWER_OFF, bench.safety.robotMode());
  }

  @Test
  void releasingBrakesWhilePowerGoesOffComesAfterwards() {
    SafetyBench bench = new SafetyBench(PowerTimes.REAL);
    bench.safety.powerOff();
    bench.step();
    assertEquals(Optional.empty(), bench.safety.releaseBrakes());
    assertEquals(
        List.of(
            RobotMode.RUNNING,
            RobotMode.BOOTING,
            RobotMode.POWER_ON,
            RobotMode.IDLE,
            RobotMode.RUNNING),
        modesDuring(bench, 1500));
  }

  @Test
  void anEmergencyStopDoesNotWait() {
    SafetyBench bench = new SafetyBench(PowerTimes.REAL);
    bench.steps(2);
    bench.safety.setInput(SafetyInput.EMERGENCY_STOP, true);
    bench.steps(2);
    assertEquals(RobotMode.POWER_OFF, bench.safety.robotMode());
  }

  @Test
  void unlockingAProtectiveStopTakesItsTime() {
    SafetyBench bench = new SafetyBench(PowerTimes.REAL);
    bench.safety.protectiveStop();
    bench.steps(UNLOCK_FRAMES);
    assertEquals(Optional.empty(), bench.safety.unlockProtectiveStop(false));
    bench.steps(49);
    assertEquals(SafetyMode.PROTECTIVE_STOP, bench.safety.safetyMode());
    bench.steps(2);
    assertEquals(SafetyMode.NORMAL, bench.safety.safetyMode());
  }

  @Test
  void aNewStopOutlastsAnUnlockUnderWay() {
    SafetyBench bench = new SafetyBench(PowerTimes.REAL);
    bench.safety.protectiveStop();
    bench.steps(UNLOCK_FRAMES);
    bench.safety.unlockProtectiveStop(false);
    bench.safety.setInput(SafetyInput.EMERGENCY_STOP, true);
    bench.steps(200);
    assertEquals(SafetyMode.ROBOT_EMERGENCY_STOP, bench.safety.safetyMode());
  }

  @Test
  void withoutTimesEveryStepTakesAFrame() {
    SafetyBench bench = new SafetyBench(PowerTimes.ofTotal(0));
    bench.safety.powerOff();
    assertEquals(RobotMode.POWER_OFF, bench.safety.robotMode());
    bench.safety.releaseBrakes();
    bench.steps(4);
    assertEquals(RobotMode.RUNNING, bench.safety.robotMode());
  }

  @Test
  void theTotalIsThatOfSwitchingOn() {
    PowerTimes times = PowerTimes.ofTotal(5.2);
    assertEquals(5.2, times.bootS() + times.powerOnS() + times.brakeS(), 1e-12);
    assertEquals(0.2, times.offS(), 1e-12);
  }

  @Test
  void refusesTimesOutOfRange() {
    for (double wrong : new double[] {-0.1, 61, Double.NaN}) {
      String message =
          assertThrows(IllegalArgumentException.class, () -> PowerTimes.ofTotal(wrong))
              .getMessage();
      assertTrue(message.contains("must be 0 to 60"), message);
    }
  }
}
