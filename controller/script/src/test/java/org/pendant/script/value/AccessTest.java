package org.pendant.script.value;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.list;
import static org.pendant.script.value.Make.matrix;
import static org.pendant.script.value.Make.pose;
import static org.pendant.script.value.Make.room;
import static org.pendant.script.value.Make.strings;
import static org.pendant.script.value.Make.struct;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

class AccessTest {
  private static void refuses(String code, String part, Executable access) {
    ScriptError error = assertThrows(ScriptError.class, access);
    assertEquals(code, error.code());
    assertTrue(error.getMessage().contains(part), error.getMessage());
  }

  @Test
  void listsPosesStructsAndMatricesHaveElements() throws ScriptError {
    assertEquals(Value.of(20), Operators.index(ints(10, 20), Value.of(1)));
    assertEquals(Value.of(0.5), Operators.index(floats(0.5), Value.of(0)));
    assertEquals(Value.of("b"), Operators.index(strings("a", "b"), Value.of(1)));
    assertEquals(Value.of(6.0), Operators.index(pose(1, 2, 3, 4, 5, 6), Value.of(5)));
    assertEquals(Value.of("x"), Operators.index(struct("a", 1, "b", "x"), Value.of(1)));
    assertEquals(ints(3, 4), Operators.index(matrix(ints(1, 2), ints(3, 4)), Value.of(1)));
    assertEquals(
        Value.of(4), Operators.index(matrix(ints(1, 2), ints(3, 4)), Value.of(1), Value.of(1)));
  }

  @Test
  void aFloatWithoutFractionIsAnIndex() throws ScriptError {
    assertEquals(Value.of(20), Operators.index(ints(10, 20), Value.of(1.0)));
    refuses("wrong-type", "1.5", () -> Operators.index(ints(10, 20), Value.of(1.5)));
    refuses("wrong-type", "a bool", () -> Operators.index(ints(10, 20), Value.of(true)));
    refuses("wrong-type", "nan", () -> Operators.index(ints(10, 20), Value.of(Double.NaN)));
  }

  @Test
  void indicesOutsideAreErrors() {
    refuses("index-out-of-range", "-1", () -> Operators.index(ints(1), Value.of(-1)));
    refuses("index-out-of-range", "0 to 1", () -> Operators.index(ints(1, 2), Value.of(2)));
    refuses("index-out-of-range", "empty", () -> Operators.index(room(3), Value.of(0)));
    refuses("index-out-of-range", "6", () -> Operators.index(pose(1, 2, 3, 4, 5, 6), Value.of(6)));
    refuses("index-out-of-range", "1", () -> Operators.index(struct("a", 1), Value.of(1)));
    refuses("index-out-of-range", "2", () -> Operators.index(matrix(ints(1)), Value.of(2)));
    refuses(
        "index-out-of-range",
        "[0, 1]",
        () -> Operators.index(matrix(ints(1)), Value.of(0), Value.of(1)));
  }

  @Test
  void otherKindsHaveNoElements() {
    refuses("wrong-type", "a string", () -> Operators.index(Value.of("abc"), Value.of(0)));
    refuses("wrong-type", "an int", () -> Operators.index(Value.of(1), Value.of(0)));
    refuses("wrong-type", "matrix", () -> Operators.index(ints(1), Value.of(0), Value.of(0)));
  }

  @Test
  void elementsChangeInPlaceAndPosesAreReplaced() throws ScriptError {
    NumberList list = ints(1, 2);
    assertSame(list, Operators.setIndex(list, Value.of(0), Value.of(10)));
    assertEquals(ints(10, 2), list);
    Operators.setIndex(list, Value.of(1), Value.of(2.5));
    assertEquals("[10, 2.5]", list.text());
    StructValue struct = struct("a", 1);
    assertSame(struct, Operators.setIndex(struct, Value.of(0), Value.of(5)));
    assertEquals(struct("a", 5), struct);
    PoseValue pose = pose(1, 2, 3, 4, 5, 6);
    assertEquals(pose(1, 2, 3, 0, 5, 6), Operators.setIndex(pose, Value.of(3), Value.of(0)));
    assertEquals(pose(1, 2, 3, 4, 5, 6), pose);
    MatrixValue matrix = matrix(ints(1, 2));
    assertSame(matrix, Operators.setIndex(matrix, Value.of(0), Value.of(1), Value.of(0.5)));
    assertEquals("[[1, 0.5]]", matrix.text());
  }

  @Test
  void elementsKeepTheirType() {
    refuses("wrong-type", "string", () -> Operators.setIndex(ints(1), Value.of(0), Value.of("a")));
    refuses("wrong-type", "bool", () -> Operators.setIndex(ints(1), Value.of(0), Value.of(true)));
    refuses(
        "wrong-type",
        "cannot become an int",
        () -> Operators.setIndex(strings("a"), Value.of(0), Value.of(1)));
    refuses(
        "wrong-type",
        "a string",
        () -> Operators.setIndex(pose(1, 2, 3, 4, 5, 6), Value.of(0), Value.of("x")));
    refuses(
        "wrong-type",
        "must be a number",
        () -> Operators.setIndex(matrix(ints(1)), Value.of(0), Value.of(0), ints(1)));
    refuses(
        "wrong-type",
        "[row, column]",
        () -> Operators.setIndex(matrix(ints(1)), Value.of(0), ints(1)));
  }

  @Test
  void membersAreReadAndChangedByName() throws ScriptError {
    StructValue struct = struct("a", 1, "b", "x");
    assertEquals(Value.of("x"), Operators.member(struct, "b"));
    assertSame(struct, Operators.setMember(struct, "a", Value.of(22.5)));
    assertEquals(Value.of(22.5), Operators.member(struct, "a"));
    refuses("unknown-member", "c", () -> Operators.member(struct, "c"));
    refuses("wrong-type", "member a", () -> Operators.setMember(struct, "a", Value.of("no")));
    refuses("wrong-type", "must be a struct", () -> Operators.member(ints(1), "a"));
  }

  @Test
  void aStructInAListKeepsTheCapacityOfItsLists() throws ScriptError {
    ListValue list = (ListValue) list(struct("q", room(5)));
    Operators.setIndex(list, Value.of(0), struct("q", ints(1, 2)));
    ListValue inner = (ListValue) Operators.member(list.get(0), "q");
    assertEquals(ints(1, 2), inner);
    assertEquals(5, inner.capacity());
  }

  @Test
  void aContainerCanBePutBackWhereItIs() throws ScriptError {
    ListValue list = (ListValue) list(struct("q", strings("a", "b")));
    Value element = Operators.open(list, Value.of(0));
    Operators.setIndex(list, Value.of(0), element);
    Operators.setMember(element, "q", Operators.member(element, "q"));
    assertSame(element, list.get(0));
    assertEquals("[{q = [\"a\", \"b\"]}]", list.text());
  }
}
