package org.pendant.script.value;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.list;
import static org.pendant.script.value.Make.matrix;
import static org.pendant.script.value.Make.pose;
import static org.pendant.script.value.Make.strings;
import static org.pendant.script.value.Make.struct;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.pendant.language.syntax.Expression.BinaryOperator;

/** What is said of values that do not fit, in each of its cases. */
class RefusedValuesTest {
  private static void refuses(String message, Executable operation) {
    assertEquals(message, assertThrows(ScriptError.class, operation).getMessage());
  }

  private static void refuses(String message, BinaryOperator operator, Value left, Value right) {
    refuses(message, () -> Operators.binary(operator, left, right));
  }

  @Test
  void twoValuesThatNothingCombines() {
    refuses(
        "*: cannot combine a bool and an int",
        BinaryOperator.MULTIPLY,
        Value.of(true),
        Value.of(1));
    refuses(
        "+: cannot combine a string and an int; to_str makes a string of a value, str_cat joins any"
            + " two",
        BinaryOperator.ADD,
        Value.of("a"),
        Value.of(1));
    refuses(
        "+: cannot combine a pose and an int; poses are combined by pose_add, pose_sub, pose_trans"
            + " and pose_inv",
        BinaryOperator.ADD,
        pose(0, 0, 0, 0, 0, 0),
        Value.of(1));
  }

  @Test
  void whatHasNoNegative() {
    refuses("-: cannot negate a string", () -> Operators.negate(Value.of("a")));
    refuses(
        "-: cannot negate a pose; poses are combined by pose_add, pose_sub, pose_trans and"
            + " pose_inv",
        () -> Operators.negate(pose(0, 0, 0, 0, 0, 0)));
  }

  @Test
  void anIndexOutside() {
    refuses("index is 0, but the list is empty", () -> Operators.index(list(), Value.of(0)));
    refuses("index is 2, must be 0 to 1", () -> Operators.index(ints(1, 2), Value.of(2)));
    refuses(
        "index is 1, must be 0 to 0 for this struct",
        () -> Operators.index(struct("a", Value.of(1)), Value.of(1)));
    refuses("index is 0.5, must be an int", () -> Operators.index(ints(1), Value.of(0.5)));
    refuses("index is a string, must be an int", () -> Operators.index(ints(1), Value.of("a")));
  }

  @Test
  void aMatrixAndWhatHasAnotherShape() throws ScriptError {
    Value matrix = matrix(ints(1, 2), ints(3, 4));
    refuses(
        "+: cannot combine a 2 x 2 matrix and a 1 x 2 matrix",
        BinaryOperator.ADD,
        matrix,
        matrix(ints(1, 2)));
    refuses(
        "*: cannot combine a 2 x 2 matrix and a 1 x 2 matrix; the first must have as many columns"
            + " as the second has rows",
        BinaryOperator.MULTIPLY,
        matrix,
        matrix(ints(1, 2)));
    refuses(
        "*: cannot combine a 2 x 2 matrix and a list of 3; it must have one element a column",
        BinaryOperator.MULTIPLY,
        matrix,
        ints(1, 2, 3));
  }

  @Test
  void anotherTypeThanTheOneThatIsThere() {
    refuses(
        "list element: is a string, cannot become an int",
        () -> Operators.setIndex(strings("a"), Value.of(0), Value.of(1)));
    refuses(
        "member a: is an int, cannot become a string",
        () -> Operators.setMember(struct("a", Value.of(1)), "a", Value.of("x")));
    refuses(
        "list: all elements must have one type, element 0 is a string, cannot become an int",
        () -> Operators.listLiteral(Value.of("a"), Value.of(1)));
    refuses(
        "has members a, not b",
        () -> Operators.assign(struct("a", Value.of(1)), struct("b", Value.of(1))));
    refuses(
        "member a member b is an int, cannot become a string",
        () ->
            Operators.assign(
                struct("a", struct("b", Value.of(1))), struct("a", struct("b", Value.of("x")))));
    refuses(
        "element member b is an int, cannot become a string",
        () -> Operators.assign(list(struct("b", Value.of(1))), list(struct("b", Value.of("x")))));
  }
}
