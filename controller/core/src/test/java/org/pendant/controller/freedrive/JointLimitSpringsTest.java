package org.pendant.controller.freedrive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;

class JointLimitSpringsTest {
  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final SafetyLimits limits = SafetyConfiguration.standard(arm).normal();
  private final double wall = arm.joints().get(0).highestRad() - JointLimitSprings.MARGIN_RAD;
  private final JointLimitSprings walls = new JointLimitSprings(arm);

  private void beginAt(double base) {
    walls.begin(at(base));
    walls.update(limits, at(base));
  }

  private static double[] at(double base) {
    return new double[] {base, -1, -1, -1, -1, 0};
  }

  @Test
  void theNearerTheWallTheSlower() {
    beginAt(0);
    double last = Double.POSITIVE_INFINITY;
    for (double q = 0; q < wall; q += 0.01) {
      double most = walls.mostRadPerS(0, q);
      assertTrue(most < last && most > 0, "at " + q);
      assertTrue(most * most / (2 * 8) < arm.joints().get(0).highestRad() - q, "can stop at " + q);
      last = most;
    }
    assertEquals(0, walls.mostRadPerS(0, wall), 1e-9);
    assertTrue(walls.mostRadPerS(0, wall + 0.01) < 0, "pushed back");
    assertEquals(-walls.mostRadPerS(0, 1), walls.leastRadPerS(0, -1), 1e-9);
  }

  @Test
  void aJointThatBeginsBeyondTheWallIsLeftThereAndTheWallFollowsIt() {
    beginAt(wall + 0.03);
    assertEquals(0, walls.mostRadPerS(0, wall + 0.03), 1e-9);
    walls.update(limits, at(wall + 0.04));
    assertTrue(walls.mostRadPerS(0, wall + 0.04) < 0, "no farther");
    walls.update(limits, at(wall + 0.01));
    assertEquals(0, walls.mostRadPerS(0, wall + 0.01), 1e-9);
    walls.update(limits, at(wall - 1));
    assertEquals(0, walls.mostRadPerS(0, wall), 1e-9);
  }

  @Test
  void aJointWithoutEndHasNoWall() {
    ArmDescription endless = ArmLibrary.load("ur3e");
    JointLimitSprings none = new JointLimitSprings(endless);
    none.begin(at(0));
    none.update(SafetyConfiguration.standard(endless).normal(), at(0));
    assertEquals(Double.POSITIVE_INFINITY, none.mostRadPerS(5, 1000));
  }
}
