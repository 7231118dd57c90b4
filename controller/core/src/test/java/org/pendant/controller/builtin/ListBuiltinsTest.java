package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.bools;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.list;
import static org.pendant.script.value.Make.matrix;
import static org.pendant.script.value.Make.pose;
import static org.pendant.script.value.Make.strings;
import static org.pendant.script.value.Make.struct;

import org.junit.jupiter.api.Test;
import org.pendant.language.signature.Type;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

class ListBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  private ListValue listOf(String name, Object... arguments) throws ScriptError {
    return (ListValue) fixture.call(name, arguments);
  }

  private Value method(String name, Object... selfAndArguments) throws ScriptError {
    return fixture.method(Type.LIST, name, selfAndArguments);
  }

  @Test
  void boolsAreBits() throws ScriptError {
    assertEquals(
        Value.of(9), fixture.call("binary_list_to_integer", bools(true, false, false, true)));
    assertEquals(Value.of(0), fixture.call("binary_list_to_integer", ints()));
    boolean[] many = new boolean[40];
    many[31] = true;
    many[35] = true;
    assertEquals(Value.of(Integer.MIN_VALUE), fixture.call("binary_list_to_integer", bools(many)));
    refuses(
        "wrong-type",
        "must be a list of bool",
        () -> fixture.call("binary_list_to_integer", ints(1, 0)));
  }

  @Test
  void intsBecomeThirtyTwoBools() throws ScriptError {
    ListValue bits = listOf("integer_to_binary_list", 57);
    assertEquals(32, bits.length());
    assertEquals("[True, False, False, True, True, True]", bits.slice(0, 6).text());
    for (int x : new int[] {0, 1, -1, 57, -57, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
      Value there = fixture.call("integer_to_binary_list", x);
      assertEquals(Value.of(x), fixture.call("binary_list_to_integer", there));
    }
    refuses("wrong-type", "x is float 0.5", () -> fixture.call("integer_to_binary_list", 0.5));
  }

  @Test
  void listsAreMadeOfEqualElements() throws ScriptError {
    ListValue words = listOf("make_list", 5, "a");
    assertEquals(strings("a", "a", "a", "a", "a"), words);
    assertEquals(5, words.capacity());
    ListValue numbers = listOf("make_list", 10, 0, 100);
    assertEquals(10, numbers.length());
    assertEquals(100, numbers.capacity());
    ListValue empty = listOf("make_list", 0, true, 100);
    assertEquals(0, empty.length());
    assertEquals(ValueKind.BOOL, empty.elementKind());
    assertEquals("[p[0, 0, 0, 0, 0, 0]]", listOf("make_list", 1, pose(0, 0, 0, 0, 0, 0)).text());
  }

  @Test
  void everyElementOfAMadeListIsItsOwn() throws ScriptError {
    StructValue initial = struct("n", 1);
    ListValue list = listOf("make_list", 2, initial, 3);
    ((StructValue) list.open(0)).set("n", Value.of(9));
    assertEquals("[{n = 9}, {n = 1}]", list.text());
    assertEquals(struct("n", 1), initial);
  }

  @Test
  void impossibleListsAreRefused() throws ScriptError {
    Value matrix = matrix(ints(1));
    refuses("value-out-of-range", "length is -1", () -> fixture.call("make_list", -1, 0));
    refuses("value-out-of-range", "capacity is 2", () -> fixture.call("make_list", 3, 0, 2));
    refuses(
        "value-out-of-range", "must be 0 to", () -> fixture.call("make_list", 2_000_000_000, 0));
    refuses("wrong-type", "initial_value", () -> fixture.call("make_list", 1, ints(1)));
    refuses("wrong-type", "initial_value", () -> fixture.call("make_list", 1, matrix));
    refuses("wrong-type", "initial_value", () -> fixture.call("make_list", 1, NoneValue.NONE));
  }

  @Test
  void lengthCountsElementsBytesAndMembers() throws ScriptError {
    assertEquals(Value.of(5), fixture.call("get_list_length", ints(1, 3, 3, 6, 2)));
    assertEquals(Value.of(9), fixture.call("length", "here I am"));
    assertEquals(Value.of(3), fixture.call("length", ints(1, 2, 3)));
    assertEquals(Value.of(2), fixture.call("length", struct("a", 1, "b", 2)));
    refuses("wrong-type", "v is int 5", () -> fixture.call("length", 5));
    refuses("wrong-type", "v is string", () -> fixture.call("get_list_length", "abc"));
  }

  @Test
  void sizeOfAMatrixIsRowsAndColumns() throws ScriptError {
    assertEquals(Value.of(9), fixture.call("size", "here I am"));
    assertEquals(Value.of(5), fixture.call("size", ints(1, 2, 3, 4, 5)));
    assertEquals(ints(3, 2), fixture.call("size", matrix(ints(1, 2), ints(3, 4), ints(5, 6))));
    refuses("wrong-type", "v is pose", () -> fixture.call("size", pose(0, 0, 0, 0, 0, 0)));
  }

  @Test
  void aListGrowsAndShrinksWithinItsCapacity() throws ScriptError {
    ListValue list = listOf("make_list", 0, 0, 4);
    assertTrue(CallFixture.nothing(method("append", list, 88)));
    method("append", list, 89.5);
    method("insert", list, 0, 1);
    method("insert", list, 3, 2);
    assertEquals("[1, 88, 89.5, 2]", list.text());
    assertEquals(Value.of(0), method("excess_capacity", list));
    refuses("list-capacity", "capacity 4", () -> method("append", list, 1));
    refuses("list-capacity", "capacity 4", () -> method("insert", list, 0, 1));
    method("remove", list, 1);
    assertEquals(Value.of(2.0), method("pop", list));
    assertEquals("[1, 89.5]", list.text());
    method("clear", list);
    assertEquals(Value.of(0), method("length", list));
    assertEquals(Value.of(4), method("capacity", list));
    refuses("index-out-of-range", "empty", () -> method("pop", list));
  }

  @Test
  void extendAddsAnotherListOrItself() throws ScriptError {
    ListValue list = listOf("make_list", 2, 0, 6);
    method("extend", list, ints(1));
    method("extend", list, list);
    assertEquals("[0, 0, 1, 0, 0, 1]", list.text());
    refuses("list-capacity", "7 elements", () -> method("extend", list, ints(1)));
    refuses("wrong-type", "string", () -> method("extend", list, strings("a")));
    refuses("wrong-type", "list is int 1", () -> method("extend", list, 1));
  }

  @Test
  void wrongPlacesAndTypesAreRefused() {
    ListValue list = ints(1, 2);
    refuses("index-out-of-range", "2", () -> method("remove", list, 2));
    refuses("index-out-of-range", "3", () -> method("insert", list, 3, 1));
    refuses("index-out-of-range", "1 to 4", () -> method("slice", list, 1, 4));
    refuses("index-out-of-range", "1 to 0", () -> method("slice", list, 1, 0));
    refuses("wrong-type", "string", () -> method("append", list, "a"));
    refuses("wrong-type", "bool", () -> method("append", list, true));
  }

  @Test
  void sliceAnswersACopy() throws ScriptError {
    ListValue list = ints(10, 11, 12, 13, 14);
    ListValue part = (ListValue) method("slice", list, 1, 3);
    part.set(0, Value.of(0));
    assertEquals("[0, 12]", part.text());
    assertEquals(ints(10, 11, 12, 13, 14), list);
    assertEquals(0, ((ListValue) method("slice", list, 5, 5)).length());
  }

  @Test
  void whatIsAppendedIsACopy() throws ScriptError {
    ListValue list = listOf("make_list", 0, struct("n", 1), 3);
    StructValue element = struct("n", 2);
    method("append", list, element);
    method("insert", list, 0, element);
    element.set("n", Value.of(7));
    assertEquals("[{n = 2}, {n = 2}]", list.text());
    method("append", list, list.get(0));
    ((StructValue) list.get(0)).set("n", Value.of(8));
    assertEquals("[{n = 8}, {n = 2}, {n = 2}]", list.text());
  }

  @Test
  void listsAndStructsHaveText() throws ScriptError {
    assertEquals(Value.of("[1, 2.5]"), method("to_string", floats(1, 2.5)));
    assertEquals(Value.of("[\"a\"]"), method("to_string", list("a")));
    assertEquals(
        Value.of("{a = 1, b = \"x\"}"),
        fixture.method(Type.STRUCT, "to_string", struct("a", 1, "b", "x")));
    assertEquals(Value.of(2), fixture.method(Type.STRUCT, "length", struct("a", 1, "b", "x")));
  }

  @Test
  void textOutOfSpaceEndsWithDots() throws ScriptError {
    String list = method("to_string", listOf("make_list", 1000, 7)).text();
    assertEquals(1023, list.length());
    assertTrue(list.endsWith("...]"), list);
    String struct = fixture.method(Type.STRUCT, "to_string", struct("s", "x".repeat(2000))).text();
    assertEquals(1023, struct.length());
    assertTrue(struct.endsWith("...}"), struct);
  }
}
