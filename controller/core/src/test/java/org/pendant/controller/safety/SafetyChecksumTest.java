package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmLibrary;

class SafetyChecksumTest {
  private static final SafetyConfiguration STANDARD =
      SafetyConfiguration.standard(ArmLibrary.load("ur5e"));

  private static SafetyPlane plane(double zM, boolean elbow) {
    return new SafetyPlane("table", 0, 0, zM, new Axis(0, 0, 1), Applies.BOTH, elbow);
  }

  @Test
  void equalConfigurationsHaveTheSame() {
    assertEquals(
        SafetyChecksum.of(STANDARD.withPlanes(plane(-0.0, true))),
        SafetyChecksum.of(
            SafetyConfiguration.standard(ArmLibrary.load("ur5e")).withPlanes(plane(0, true))));
  }

  @Test
  void whatDiffersHasAnotherOne() {
    List<SafetyConfiguration> all =
        List.of(
            STANDARD,
            SafetyConfiguration.standard(ArmLibrary.load("ur10e")),
            STANDARD.withLimits(STANDARD.normal(), STANDARD.normal()),
            STANDARD.withPlanes(plane(0.1, false)),
            STANDARD.withPlanes(plane(0.1, true)),
            STANDARD.withPlanes(plane(0.2, true)),
            STANDARD.withToolDirection(
                new ToolDirection(new Axis(0, 0, -1), new Axis(0, 0, 1), 0.5, Applies.BOTH)),
            STANDARD.withToolDirection(
                new ToolDirection(new Axis(0, 0, -1), new Axis(0, 0, 1), 0.5, Applies.REDUCED)));
    Set<SafetyChecksum> sums = new HashSet<>(all.stream().map(SafetyChecksum::of).toList());
    assertEquals(all.size(), sums.size());
  }

  @Test
  void isShownInFourGroups() {
    assertEquals("57-F4-28-5B", new SafetyChecksum(0x57F4285B).toString());
    assertTrue(SafetyChecksum.of(STANDARD).toString().matches("([0-9A-F]{2}-){3}[0-9A-F]{2}"));
  }

  @Test
  void aDirectionMadeOfItsOwnNumbersIsTheSame() {
    for (int i = 1; i < 1000; i++) {
      Axis axis = new Axis(Math.sin(i), Math.cos(7 * i), Math.sin(3 * i));
      assertEquals(axis, new Axis(axis.x(), axis.y(), axis.z()));
    }
  }
}
