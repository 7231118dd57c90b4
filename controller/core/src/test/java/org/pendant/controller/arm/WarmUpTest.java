package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class WarmUpTest {

  @Test
  void beginsColdAndEndsWarm() {
    assertEquals(25, WarmUp.CONTROL_BOX.temperatureC(0));
    assertEquals(38, WarmUp.CONTROL_BOX.temperatureC(24 * 3600), 1e-6);
  }

  @Test
  void doesMostOfTheWayInOneTimeConstant() {
    assertEquals(20 + 10 * 0.632, new WarmUp(20, 30, 600).temperatureC(600), 0.01);
  }

  @Test
  void refusesATimeConstantOfNothing() {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> new WarmUp(20, 30, 0));
    assertEquals("warm-up: time constant is 0.0 s, must be above 0", refused.getMessage());
  }
}
