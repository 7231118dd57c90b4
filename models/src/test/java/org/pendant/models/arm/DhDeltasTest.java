package org.pendant.models.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class DhDeltasTest {
  @Test
  void numbersThatAreNotFiniteAreRefusedByNameAndJoint() {
    Joints none = Joints.ZERO;
    Joints nan = none.with(4, Double.NaN);
    Joints infinite = none.with(0, Double.POSITIVE_INFINITY);
    assertEquals(
        "dh deltas: theta of joint 4 is NaN rad, must be finite",
        refusal(() -> new DhDeltas(nan, none, none, none)));
    assertEquals(
        "dh deltas: a of joint 0 is Infinity m, must be finite",
        refusal(() -> new DhDeltas(none, infinite, none, none)));
    assertEquals(
        "dh deltas: d of joint 4 is NaN m, must be finite",
        refusal(() -> new DhDeltas(none, none, nan, none)));
    assertEquals(
        "dh deltas: alpha of joint 0 is Infinity rad, must be finite",
        refusal(() -> new DhDeltas(none, none, none, infinite)));
  }

  private static String refusal(Runnable making) {
    return assertThrows(IllegalArgumentException.class, making::run).getMessage();
  }
}
