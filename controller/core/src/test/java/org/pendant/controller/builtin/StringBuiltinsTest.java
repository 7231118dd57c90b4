package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.bools;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.list;
import static org.pendant.script.value.Make.matrix;
import static org.pendant.script.value.Make.pose;
import static org.pendant.script.value.Make.strings;
import static org.pendant.script.value.Make.struct;
import static org.pendant.script.value.Make.value;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

class StringBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  private void answers(Object expected, String name, Object... arguments) throws ScriptError {
    assertEquals(value(expected), fixture.call(name, arguments));
  }

  private void outside(String part, String name, Object... arguments) {
    refuses("index-out-of-range", part, () -> fixture.call(name, arguments));
  }

  @Test
  void bytesAreReadByIndex() throws ScriptError {
    answers("H", "str_at", "Hello", 0);
    answers("e", "str_at", "Hello", 1);
    outside("str_at: index is 10, must be 0 to 4", "str_at", "Hello", 10);
    outside("index is -1", "str_at", "Hello", -1);
    outside("src is empty", "str_at", "", 0);
  }

  @Test
  void valuesAreJoinedAsText() throws ScriptError {
    answers("Hello World!", "str_cat", "Hello", " World!");
    answers("Integer 1", "str_cat", "Integer ", 1);
    answers("p[1, 2, 3, 4, 5, 6]", "str_cat", "", pose(1, 2, 3, 4, 5, 6));
    answers("[True, False, True][1, 0, 1]", "str_cat", bools(true, false, true), ints(1, 0, 1));
    answers("34", "str_cat", 3, 4);
    answers("1.5False", "str_cat", 1.5, false);
    answers("[p[0, 0, 0, 0, 0, 1]]", "str_cat", list(pose(0, 0, 0, 0, 0, 1)), "");
  }

  @Test
  void otherKindsHaveNoTextHere() throws ScriptError {
    for (Value value : List.of(struct("a", 1), matrix(ints(1)), strings("a"), NoneValue.NONE)) {
      refuses("wrong-type", "str_cat: op2 is", () -> fixture.call("str_cat", "", value));
      refuses("wrong-type", "to_str: val is", () -> fixture.call("to_str", value));
    }
  }

  @Test
  void resultsHaveAtMost1023Characters() throws ScriptError {
    String most = "x".repeat(1022);
    answers(most + "1", "str_cat", most, 1);
    refuses("string-too-long", "1024", () -> fixture.call("str_cat", most, "ab"));
    Value numbers = fixture.call("make_list", 1000, 1);
    refuses("string-too-long", "1023", () -> fixture.call("to_str", numbers));
  }

  @Test
  void lengthIsCountedInBytes() throws ScriptError {
    answers(5, "str_len", "Hello");
    answers(0, "str_len", "");
    answers(2, "str_len", "\u00c3\u00a9");
    answers(true, "str_empty", "");
    answers(false, "str_empty", "Hello");
    refuses("wrong-type", "str is int 5", () -> fixture.call("str_len", 5));
  }

  @Test
  void stringsAreFound() throws ScriptError {
    answers(4, "str_find", "Hello World!", "o");
    answers(3, "str_find", "Hello World!", "lo");
    answers(7, "str_find", "Hello World!", "o", 5);
    answers(-1, "str_find", "abc", "z");
    answers(-1, "str_find", "abc", "a", 99);
    answers(3, "str_find", "abc", "", 3);
    outside("start_from is -1", "str_find", "abc", "a", -1);
  }

  @Test
  void partsAreCutOut() throws ScriptError {
    answers("567", "str_sub", "0123456789abcdefghij", 5, 3);
    answers("abcdefghij", "str_sub", "0123456789abcdefghij", 10);
    answers("", "str_sub", "0123456789abcdefghij", 2, 0);
    answers("cde", "str_sub", "abcde", 2, 50);
    answers("cde", "str_sub", "abcde", 2, Integer.MAX_VALUE);
    answers("", "str_sub", "abcde", 5);
    outside("index is -5, must be 0 to 5", "str_sub", "abcde", -5, 50);
    outside("index is 6", "str_sub", "abcde", 6);
    outside("len is -1", "str_sub", "abcde", 0, -1);
  }

  @Test
  void valuesBecomeText() throws ScriptError {
    answers("10", "to_str", 10);
    answers("2.123456", "to_str", 2.123456123456);
    answers("p[1, 2, 3, 4, 5, 6]", "to_str", pose(1, 2, 3, 4, 5, 6));
    answers("[True, False, True]", "to_str", bools(true, false, true));
    answers("text", "to_str", "text");
  }

  @Test
  void textBecomesNumbers() throws ScriptError {
    answers(10, "to_num", "10");
    answers(3.14, "to_num", "3.14");
    answers(-3.0e5, "to_num", "-3.0e5");
    answers(5.0, "to_num", "+5.");
    answers(0.36, "to_num", ".36");
    answers(-2.0, "to_num", "-2.0");
    answers(2.5e-5, "to_num", "2.5E-5");
    answers(42, "to_num", " \t\n42");
    answers(0x3A, "to_num", "0X3A");
    answers(0xb5, "to_num", "0xb5");
    answers(-16, "to_num", "-0x10");
    answers(Integer.MIN_VALUE, "to_num", "-2147483648");
  }

  @Test
  void anExponentWithoutPointGivesAnIntUnlessAFractionIsLeft() throws ScriptError {
    answers(10000, "to_num", "10e3");
    answers(-0.0005, "to_num", "-5e-4");
  }

  @Test
  void infinityAndNotANumberHaveNames() throws ScriptError {
    answers(Double.POSITIVE_INFINITY, "to_num", "INF");
    answers(Double.NEGATIVE_INFINITY, "to_num", "-infinity");
    answers(Double.NaN, "to_num", "NaN");
  }

  @Test
  void whatIsNoNumberIsRefused() {
    for (String text :
        List.of(
            "", " ", "123abc", "1 ", "1 2", ".", "+", "--1", "e5", "1e", "1e+", "0x", "0xg", "1,5",
            "1.2.3", "in", "infinit", "nanny", "0x1.8p3", "1f", "1d")) {
      refuses("not-a-number", "\"" + text + "\"", () -> fixture.call("to_num", text));
    }
  }

  @Test
  void numbersThatDoNotFitAreRefused() {
    for (String text :
        List.of(
            "2147483648",
            "-2147483649",
            "99999999999",
            "1e10",
            "0xffffffff",
            "0x" + "f".repeat(500),
            "1.0e400",
            "9".repeat(500),
            "1e999999999999")) {
      refuses("value-out-of-range", "to_num: str is", () -> fixture.call("to_num", text));
    }
  }

  @Test
  void assertStopsOnlyWhenTheConditionIsFalse() throws ScriptError {
    assertTrue(CallFixture.nothing(fixture.call("assert", true)));
    refuses("assertion-failed", "condition", () -> fixture.call("assert", false));
    refuses("wrong-type", "condition is string", () -> fixture.call("assert", "yes"));
  }
}
