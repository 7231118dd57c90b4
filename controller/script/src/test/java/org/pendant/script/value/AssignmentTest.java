package org.pendant.script.value;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.script.value.Make.bools;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.list;
import static org.pendant.script.value.Make.matrix;
import static org.pendant.script.value.Make.pose;
import static org.pendant.script.value.Make.room;
import static org.pendant.script.value.Make.strings;
import static org.pendant.script.value.Make.struct;

import org.junit.jupiter.api.Test;

class AssignmentTest {
  private static void refuses(String code, String message, Value current, Value incoming) {
    ScriptError error = assertThrows(ScriptError.class, () -> Operators.assign(current, incoming));
    assertEquals(code, error.code());
    assertEquals(message, error.getMessage());
  }

  @Test
  void intsAndFloatsAreOneType() throws ScriptError {
    assertEquals(Value.of(2.5), Operators.assign(Value.of(1), Value.of(2.5)));
    assertEquals(Value.of(1), Operators.assign(Value.of(2.5), Value.of(1)));
  }

  @Test
  void aVariableKeepsItsType() {
    refuses("wrong-type", "is a bool, cannot become a string", Value.of(true), Value.of("x"));
    refuses("wrong-type", "is an int, cannot become a bool", Value.of(1), Value.of(true));
    refuses("wrong-type", "is a string, cannot become None", Value.of("x"), NoneValue.NONE);
    refuses("wrong-type", "is a pose, cannot become a list", pose(0, 0, 0, 0, 0, 0), ints(1, 2));
    refuses("wrong-type", "is a list of int, cannot become a list of bool", ints(1), bools(true));
    refuses(
        "wrong-type", "is a list of string, cannot become a list of int", strings("a"), ints(1));
  }

  @Test
  void noneBecomesAnything() throws ScriptError {
    assertEquals(Value.of("x"), Operators.assign(NoneValue.NONE, Value.of("x")));
  }

  @Test
  void aListKeepsItsCapacity() throws ScriptError {
    NumberList list = ints(1, 2, 3, 4, 5, 6);
    assertSame(list, Operators.assign(list, NumberList.owning(new double[100], 5, ValueKind.INT)));
    assertEquals(5, list.length());
    assertEquals(6, list.capacity());
    Operators.assign(list, floats(0.5));
    assertEquals("[0.5]", list.text());
    Operators.assign(list, list());
    assertEquals(0, list.length());
    refuses(
        "list-capacity", "3 elements do not fit a list with capacity 2", ints(1, 2), ints(1, 2, 3));
  }

  @Test
  void listsOfObjectsTakeOnlyTheSameType() throws ScriptError {
    ListValue list = (ListValue) list(struct("a", 1), struct("a", 2));
    Operators.assign(list, list(struct("a", 0.5)));
    assertEquals("[{a = 0.5}]", list.text());
    assertThrows(ScriptError.class, () -> Operators.assign(list, list(struct("b", 1))));
    ListValue words = strings("a", "b");
    Operators.assign(words, list());
    assertEquals(0, words.length());
  }

  @Test
  void aStructTakesTheSameMembersAndKeepsItsLists() throws ScriptError {
    StructValue struct = struct("n", 1, "l", room(4));
    assertSame(struct, Operators.assign(struct, struct("n", 2.5, "l", ints(7))));
    assertEquals("{n = 2.5, l = [7]}", struct.text());
    assertEquals(4, ((ListValue) struct.get("l")).capacity());
    refuses("wrong-type", "has members n, l, not n, m", struct, struct("n", 1, "m", ints(7)));
    refuses(
        "wrong-type",
        "member n is a float, cannot become a string",
        struct,
        struct("n", "x", "l", ints(7)));
  }

  @Test
  void aMatrixKeepsItsShape() throws ScriptError {
    MatrixValue other = matrix(floats(0.5, 1));
    assertSame(other, Operators.assign(matrix(ints(1, 2)), other));
    refuses(
        "wrong-type",
        "is a 1 x 2 matrix, cannot become a 2 x 1 matrix",
        matrix(ints(1, 2)),
        matrix(ints(1), ints(2)));
  }

  @Test
  void everyRefusalNamesBothSides() {
    ScriptError error =
        assertThrows(ScriptError.class, () -> Operators.assign(matrix(ints(1)), Value.of("text")));
    assertTrue(error.getMessage().contains("matrix"), error.getMessage());
    assertTrue(error.getMessage().contains("string"), error.getMessage());
  }
}
