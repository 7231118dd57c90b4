package org.pendant.models.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class FrictionCurveTest {
  private final FrictionCurve elbow = new FrictionCurve(0.642, 0.365, 0.535, 0.663, 0);

  private double slope(double speed) {
    return (elbow.currentA(speed + 1e-6, 0) - elbow.currentA(speed - 1e-6, 0)) / 2e-6;
  }

  @Test
  void isExactlyNothingAtStandstillAndOpposesEitherDirectionAlike() {
    assertEquals(0, elbow.currentA(0, 50));
    for (double speed = 1e-4; speed < 3; speed *= 2) {
      assertEquals(-elbow.currentA(speed, 50), elbow.currentA(-speed, 50));
    }
  }

  @Test
  void passesThroughStandstillWithinHundredthsOfARadianASecond() {
    FrictionCurve wrist2 = new FrictionCurve(0.153, 0, 0.48, 0.139, 0);
    assertEquals(0.003, wrist2.currentA(0.0002, 0), 0.002);
    assertEquals(0.118, wrist2.currentA(0.0077, 0), 0.003);
    assertEquals(0.153 + 0.139, wrist2.currentA(1, 0), 1e-12);
  }

  @Test
  void isConcave() {
    for (double speed = 0.2; speed < 3; speed += 0.1) {
      assertTrue(slope(speed) < slope(speed - 0.1), "at " + speed);
    }
  }

  @Test
  void secantIsTheSpeedDependentPartOverTheSpeed() {
    for (double speed : new double[] {-2, -0.1, 1e-5, 0.3, 1.5}) {
      assertEquals(elbow.speedDependentA(speed) / speed, elbow.speedDependentASPerRad(speed), 1e-9);
    }
    assertEquals(0.365 / 0.535 + 0.663, elbow.speedDependentASPerRad(0), 1e-12);
  }

  @Test
  void growsWithTheLoadWhereItIsToldTo() {
    FrictionCurve shoulder = new FrictionCurve(0.262, 0.034, 0.45, 0.248, 0.006);
    assertEquals(0.06, shoulder.currentA(1, -10) - shoulder.currentA(1, 0), 1e-12);
    assertEquals(0.322, shoulder.dryA(10), 1e-12);
  }

  @Test
  void impossibleNumbersAreRefused() {
    assertEquals(
        "friction: coulombA is -1.0 A, curvedA 0.0 A, viscousASPerRad 0.0 A s/rad, loadAPerNm 0.0"
            + " A/Nm, none may be negative",
        assertThrows(IllegalArgumentException.class, () -> new FrictionCurve(-1, 0, 1, 0, 0))
            .getMessage());
    assertEquals(
        "friction: curveSpeedRadPerS is 0.0 rad/s, must be above 0",
        assertThrows(IllegalArgumentException.class, () -> new FrictionCurve(0, 0, 0, 0, 0))
            .getMessage());
  }
}
