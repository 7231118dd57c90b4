package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.unit.DisplayUnit;

/** Numbers that follow the robot until the user types over one. */
final class DraftTest {
  private final Draft draft =
      new Draft(
          List.of(DisplayUnit.MILLIMETRE, DisplayUnit.DEGREE),
          (index, value) -> value > 1 ? Optional.of("must be at most 1") : Optional.empty());

  @Test
  void numbersFollowTheRobotUntilSomebodyTypes() {
    draft.follow(new double[] {0.1, 0.5});
    assertEquals("100.00", draft.text(0));
    draft.type(0, "200");
    draft.follow(new double[] {0.3, 0.6});
    assertEquals("200", draft.text(0));
    assertArrayEquals(new double[] {0.2, 0.5}, draft.values(), 1e-15);
    assertTrue(draft.edited());
    draft.reset();
    draft.follow(new double[] {0.3, 0.6});
    assertEquals("300.00", draft.text(0));
  }

  @Test
  void aNumberThatNobodyTypedKeepsItsPrecision() {
    draft.follow(new double[] {0.123456789, 0.987654321});
    draft.type(1, "30");
    assertEquals(0.123456789, draft.values()[0]);
  }

  @Test
  void aProblemStaysAtItsFieldUntilItIsSolved() {
    draft.type(1, "x");
    assertFalse(draft.valid());
    assertEquals("", draft.problem(0));
    assertTrue(draft.problem(1).startsWith("'x' is not a number"), draft.problem(1));
    draft.type(0, "2 m");
    assertEquals("must be at most 1", draft.problem(0));
    draft.type(0, "0.5 m");
    draft.type(1, "10");
    assertTrue(draft.valid());
    assertEquals("", draft.problem());
  }

  @Test
  void otherUnitsShowTheSameNumbers() {
    draft.follow(new double[] {0.0254, Math.PI / 2});
    draft.type(0, "50.8");
    draft.convert(List.of(DisplayUnit.INCH, DisplayUnit.RADIAN), draft.values());
    assertEquals("2.0000", draft.text(0));
    assertEquals("1.57080", draft.text(1));
    assertTrue(draft.edited(), "what was typed is still a goal");
    assertArrayEquals(new double[] {0.0508, Math.PI / 2}, draft.values(), 1e-15);
  }

  @Test
  void otherUnitsShowTheLastGoodNumberInsteadOfABadOne() {
    draft.follow(new double[] {0.0254, 0});
    draft.type(0, "5x");
    draft.convert(List.of(DisplayUnit.INCH, DisplayUnit.DEGREE), draft.values());
    assertEquals("1.0000", draft.text(0));
    assertTrue(draft.valid());
  }
}
