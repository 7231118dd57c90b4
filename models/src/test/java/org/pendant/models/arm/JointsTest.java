package org.pendant.models.arm;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class JointsTest {
  private final Joints q = Joints.of(1, 2, 3, 4, 5, 6);

  @Test
  void valuesAreReadAndReplacedByIndex() {
    for (int i = 0; i < Joints.COUNT; i++) {
      assertEquals(i + 1, q.get(i));
      assertEquals(-1, q.with(i, -1).get(i));
      assertEquals(q, q.with(i, -1).with(i, i + 1));
    }
    assertThrows(IndexOutOfBoundsException.class, () -> q.get(6));
    assertThrows(IndexOutOfBoundsException.class, () -> q.with(-1, 0));
  }

  @Test
  void onlySixValuesMakeJoints() {
    assertThrows(IllegalArgumentException.class, () -> Joints.of(1, 2, 3, 4, 5));
  }

  @Test
  void valuesAreCopiedIntoArrays() {
    double[] target = new double[6];
    q.copyTo(target);
    assertArrayEquals(new double[] {1, 2, 3, 4, 5, 6}, target);
    assertArrayEquals(target, q.toArray());
  }

  @Test
  void distancesCompareJointByJoint() {
    Joints other = q.with(1, 5).with(4, 1);
    assertEquals(4, q.maxAbsDifference(other));
    assertEquals(25, q.squaredDistance(other));
  }

  @Test
  void oneValueThatIsNotFiniteMakesAllNotFinite() {
    assertTrue(q.isFinite());
    for (int i = 0; i < Joints.COUNT; i++) {
      assertFalse(q.with(i, Double.NaN).isFinite());
      assertFalse(q.with(i, Double.NEGATIVE_INFINITY).isFinite());
    }
  }
}
