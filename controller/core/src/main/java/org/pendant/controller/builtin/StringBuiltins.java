package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;
import org.pendant.script.value.ValueText;

/** Functions of strings, which count bytes (manual 16.56 to 16.61, 16.64, 16.65). */
final class StringBuiltins {
  /** Most characters of a string that these functions make (manual 16.57). */
  static final int MAX_LENGTH = 1023;

  /** Characters that are made to tell how long a text would be. */
  private static final int MAX_CONVERTED = 65_536;

  private static final int CONVERTED_NS = 10;
  private static final int NUMBER_NS = 300;
  private static final int SEARCHED_NS = 6;
  private static final int TEXT_NS = 10_000;
  private static final String MODULE = "internals";

  private StringBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareParts(builtins);
    declareConversions(builtins);
  }

  private static void declareParts(Builtins<ControlBox> builtins) {
    builtins
        .declare("str_at")
        .manual(MODULE, "16.56")
        .doc("The byte at index, counted from 0, as a string.")
        .needs("src", Type.STRING)
        .needs("index", Type.INT)
        .returns(Type.STRING)
        .effect(Effect.COMPUTES)
        .does(StringBuiltins::at);
    builtins
        .declare("str_empty")
        .manual(MODULE, "16.58")
        .doc("Whether the string has no bytes.")
        .needs("str", Type.STRING)
        .returns(Type.BOOL)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(call.text(0).isEmpty()));
    builtins
        .declare("str_find")
        .manual(MODULE, "16.59")
        .doc("Where target first stands in src, at start_from or later; -1 when it does not.")
        .needs("src", Type.STRING)
        .needs("target", Type.STRING)
        .takes("start_from", Type.INT, Value.of(0))
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(StringBuiltins::find);
    builtins
        .declare("str_len")
        .manual(MODULE, "16.60")
        .doc("The number of bytes of a string.")
        .needs("str", Type.STRING)
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(call -> call.answerInt(call.text(0).length()));
    builtins
        .declare("str_sub")
        .manual(MODULE, "16.61")
        .doc("At most len bytes of src from index on; without len all of them.")
        .needs("src", Type.STRING)
        .needs("index", Type.INT)
        .mayTake("len", Type.INT, Unit.NONE, "to end")
        .returns(Type.STRING)
        .effect(Effect.COMPUTES)
        .does(StringBuiltins::sub);
  }

  private static void declareConversions(Builtins<ControlBox> builtins) {
    builtins
        .declare("str_cat")
        .manual(MODULE, "16.57")
        .doc(
            "Joins two values, each a string, bool, number, pose or a list of bools, numbers or"
                + " poses. A result of more than 1023 characters is an error.")
        .needs("op1", Type.ANY)
        .needs("op2", Type.ANY)
        .returns(Type.STRING)
        .effect(Effect.COMPUTES)
        .does(call -> answerLimited(call, convertible(call, 0).concat(convertible(call, 1))));
    builtins
        .declare("to_num")
        .manual(MODULE, "16.64")
        .doc(
            "The number that a string spells: decimal, hexadecimal after 0x, inf or nan. With a"
                + " decimal point it is a float, otherwise an int.")
        .needs("str", Type.STRING)
        .returns(Type.NUMBER)
        .effect(Effect.COMPUTES)
        .costs(NUMBER_NS)
        .does(call -> call.answer(NumberParser.parse(call)));
    builtins
        .declare("to_str")
        .manual(MODULE, "16.65")
        .doc(
            "The text of a bool, number, string, pose or a list of bools, numbers or poses; floats"
                + " with up to six decimals. More than 1023 characters are an error.")
        .needs("val", Type.ANY)
        .returns(Type.STRING)
        .effect(Effect.COMPUTES)
        .does(call -> answerLimited(call, convertible(call, 0)));
  }

  /** {@code to_string} of a list, matrix or struct: never an error, shortened when too long. */
  static Outcome toStringMethod(Call<?> call) {
    call.charge(TEXT_NS);
    return call.answer(ValueText.shortened(call.value(0), MAX_LENGTH));
  }

  private static Outcome at(Call<?> call) throws ScriptError {
    String src = call.text(0);
    if (src.isEmpty()) {
      throw call.failure("index-out-of-range", text("emptySource"));
    }
    int index = inBounds(call, 1, src.length() - 1);
    return call.answer(src.substring(index, index + 1));
  }

  private static Outcome find(Call<?> call) throws ScriptError {
    int start = inBounds(call, 2, Integer.MAX_VALUE);
    String src = call.text(0);
    String target = call.text(1);
    call.charge(SEARCHED_NS * ((long) src.length() + target.length()));
    return call.answerInt(start > src.length() ? -1 : StringSearch.find(src, target, start));
  }

  private static Outcome sub(Call<?> call) throws ScriptError {
    String src = call.text(0);
    int index = inBounds(call, 1, src.length());
    int rest = src.length() - index;
    int length = call.given(2) ? Math.min(inBounds(call, 2, Integer.MAX_VALUE), rest) : rest;
    call.charge(length / 8);
    return call.answer(src.substring(index, index + length));
  }

  private static int inBounds(Call<?> call, int argument, int last) throws ScriptError {
    int index = call.integer(argument);
    if (index < 0 || index > last) {
      throw new ScriptError(
          "index-out-of-range",
          call.refuse(
                  argument, last == Integer.MAX_VALUE ? text("notNegative") : text("zeroTo", last))
              .getMessage());
    }
    return index;
  }

  /** The text of an argument of a kind that the manual lists for conversion. */
  private static String convertible(Call<?> call, int argument) throws ScriptError {
    // without a value object for the most usual case
    String text =
        call.isInt(argument) ? Integer.toString(call.integer(argument)) : start(call, argument);
    call.charge(text.length() * (long) CONVERTED_NS);
    return text;
  }

  private static String start(Call<?> call, int argument) throws ScriptError {
    Value value = call.value(argument);
    boolean allowed =
        switch (value.kind()) {
          case STRING, BOOL, INT, FLOAT, POSE -> true;
          case LIST -> {
            ValueKind element = ((ListValue) value).elementKind();
            yield element.isNumber() || element == ValueKind.BOOL || element == ValueKind.POSE;
          }
          case NONE, MATRIX, STRUCT, HANDLE -> false;
        };
    if (!allowed) {
      throw call.wrongKind(argument, text("convertible"));
    }
    return ValueText.start(value, MAX_CONVERTED);
  }

  private static Outcome answerLimited(Call<?> call, String text) throws ScriptError {
    if (text.length() > MAX_LENGTH) {
      throw call.failure(
          "string-too-long",
          text.length() > MAX_CONVERTED
              ? text("resultMuchTooLong", MAX_CONVERTED, MAX_LENGTH)
              : text("resultTooLong", text.length(), MAX_LENGTH));
    }
    return call.answer(text);
  }
}
