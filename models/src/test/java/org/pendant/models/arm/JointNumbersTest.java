package org.pendant.models.arm;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class JointNumbersTest {
  private static final double[] ONE_TO_SIX = {1, 2, 3, 4, 5, 6};
  private static final double[] NEGATIVE_ZEROS = {-0.0, 0, 0, 0, 0, 0};

  private final JointNumbers numbers = new JointNumbers();

  @Test
  void aLastingValueIsMadeOnceAsLongAsTheNumbersStay() {
    numbers.set(ONE_TO_SIX);
    Joints lasting = numbers.joints();

    assertEquals(new Joints(1, 2, 3, 4, 5, 6), lasting);
    assertSame(lasting, numbers.joints());
    numbers.update(ONE_TO_SIX);
    assertSame(lasting, numbers.joints());
    numbers.set(ONE_TO_SIX);
    assertNotSame(lasting, numbers.joints());
  }

  @Test
  void whoTakesThemOverKeepsThemWhenTheyChange() {
    numbers.set(ONE_TO_SIX);
    JointNumbers taken = new JointNumbers();
    taken.set(numbers);

    numbers.setZero();

    assertEquals(new Joints(1, 2, 3, 4, 5, 6), taken.joints());
    assertFalse(taken.same(numbers));
  }

  @Test
  void zerosHaveNoSign() {
    numbers.set(NEGATIVE_ZEROS);
    double[] copy = ONE_TO_SIX.clone();

    numbers.copyTo(copy);

    assertSame(Joints.ZERO, numbers.joints());
    assertArrayEquals(new double[Joints.COUNT], copy, 0);
    assertTrue(numbers.same(new JointNumbers()));
  }

  @Test
  void aLastingValueIsTakenOverAsItIs() {
    Joints value = new Joints(6, 5, 4, 3, 2, 1);

    assertSame(value, JointNumbers.of(value).joints());
    assertEquals(5, JointNumbers.of(value).get(1));
  }
}
