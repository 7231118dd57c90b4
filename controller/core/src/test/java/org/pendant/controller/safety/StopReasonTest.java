package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** How the numbers of stops read. */
class StopReasonTest {
  private static void assertEnds(String end, SafetyStop stop) {
    assertTrue(stop.message().endsWith(": " + end), stop.message());
  }

  @Test
  void numbersHaveFourDigitsAtMostAndNoPartsOfAMicrometre() {
    assertEnds(
        "0.00007 m, limit 0 m", StopReason.LINK_HIT.ofLink("the arm is in it", 3, 1, 0.000069921));
    assertEnds("125 Nm, limit 52.5 Nm", StopReason.COLLISION.ofJoint(1, 1, 125.03, 52.5));
  }

  @Test
  void aNumberThatIsJustBeyondItsLimitIsToldFromIt() {
    assertEnds(
        "6.3356 rad, limit 6.3355 rad", StopReason.JOINT_POSITION.ofJoint(0, 1, 6.33556, 6.33554));
    assertEnds(
        "0.0000004 m, limit 0 m", StopReason.LINK_HIT.ofLink("the arm is in it", 3, 1, 4e-7));
  }

  @Test
  void noNumberIsSaidToBeNone() {
    assertEquals(
        "C191A0 violation at 1.000 s: base (joint 0) is beyond its position limit: NaN rad,"
            + " limit 6.336 rad",
        StopReason.JOINT_POSITION.ofJoint(0, 1, Double.NaN, 6.33554).message());
  }
}
