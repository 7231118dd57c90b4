package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class MaterialTest {
  private final Material material = new Material(1e4, 0.2, 0.5);

  @Test
  void springPushesInProportionToDepth() {
    assertEquals(10, material.normalForceN(0.001, 0), 1e-12);
    assertEquals(20, material.normalForceN(0.002, 0), 1e-12);
  }

  @Test
  void goingInMeetsMoreForceThanComingOut() {
    assertEquals(10 * 1.03, material.normalForceN(0.001, -0.1), 1e-12);
    assertEquals(10 * 0.97, material.normalForceN(0.001, 0.1), 1e-12);
  }

  @Test
  void leavingFastNeverPulls() {
    assertEquals(0, material.normalForceN(0.001, 100));
  }

  @Test
  void slidingMeetsCoulombsFriction() {
    assertEquals(0.5 * 10, material.dragNSPerM(10, 0.2) * 0.2, 1e-12);
  }

  @Test
  void frictionVanishesWithSpeed() {
    assertEquals(2.5, material.dragNSPerM(5, 1e-3) * 1e-3, 1e-12);
    assertEquals(0.25, material.dragNSPerM(5, 1e-4) * 1e-4, 1e-12);
  }

  @Test
  void frictionOfHeavyPressingRisesNoSteeperThanTheSteepest() {
    assertEquals(4000, material.dragNSPerM(1000, 1e-3));
    assertEquals(4000, material.dragNSPerM(1000, 0.1));
    assertEquals(2500, material.dragNSPerM(1000, 0.2));
  }

  @Test
  void wellWithinTheRangesIsAllowed() {
    assertEquals(0, new Material(10, 0, 0).friction());
    assertEquals(2, new Material(2e5, 2, 2).friction());
  }

  @Test
  void numbersOutsideTheirRangeAreRefused() {
    assertRefused("stiffness is 9 N/m, must be 10 to 200000 N/m", 9, 0.2, 0.3);
    assertRefused("stiffness is NaN N/m, must be 10 to 200000 N/m", Double.NaN, 0.2, 0.3);
    assertRefused("damping is -0.1 s/m, must be 0 to 2 s/m", 1e4, -0.1, 0.3);
    assertRefused("friction is 2.5, must be 0 to 2", 1e4, 0.2, 2.5);
  }

  @Test
  void steepestFrictionAndStiffestSpringSuitSmallSteps() {
    double lightKg = 2;
    assertTrue(0.002 < 2 * Math.sqrt(lightKg / Material.STIFFNESS.most()));
    assertTrue(0.001 <= 2 * lightKg / Material.MAX_DRAG_N_S_PER_M);
  }

  private static void assertRefused(String message, double k, double e, double mu) {
    assertEquals(
        message,
        assertThrows(IllegalArgumentException.class, () -> new Material(k, e, mu)).getMessage());
  }
}
