package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.Operators;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueText;

/** Assertions about values: what does not hold ends the test, which is red then. */
final class AssertionBuiltins {
  private static final String SECTION = "Assertions";

  /** Characters of a value that a message shows. */
  private static final int MAX_SHOWN = 200;

  /** Bytes that are compared in a nanosecond, roughly. */
  private static final int BYTES_A_NS = 8;

  private AssertionBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "assert_true", SECTION)
        .doc("Fails the test unless the condition is True.")
        .needs("condition", Type.BOOL)
        .takes("message", Type.STRING, Value.of(""))
        .effect(Effect.COMPUTES)
        .does(call -> check(call, call.bool(0), text("conditionFalse"), 1));
    TestBuiltins.declare(builtins, "assert_false", SECTION)
        .doc("Fails the test unless the condition is False.")
        .needs("condition", Type.BOOL)
        .takes("message", Type.STRING, Value.of(""))
        .effect(Effect.COMPUTES)
        .does(call -> check(call, !call.bool(0), text("conditionTrue"), 1));
    TestBuiltins.declare(builtins, "assert_equal", SECTION)
        .doc(
            "Fails the test unless both values are equal, as == compares them; numbers that are"
                + " computed are better compared by assert_near.")
        .needs("actual", Type.ANY)
        .needs("expected", Type.ANY)
        .takes("message", Type.STRING, Value.of(""))
        .effect(Effect.COMPUTES)
        .does(call -> equal(call, true));
    TestBuiltins.declare(builtins, "assert_not_equal", SECTION)
        .doc("Fails the test if both values are equal.")
        .needs("actual", Type.ANY)
        .needs("unexpected", Type.ANY)
        .takes("message", Type.STRING, Value.of(""))
        .effect(Effect.COMPUTES)
        .does(call -> equal(call, false));
    TestBuiltins.declare(builtins, "assert_contains", SECTION)
        .doc("Fails the test unless a string contains a piece of text, or a list an element.")
        .needs("whole", Type.ANY)
        .needs("part", Type.ANY)
        .takes("message", Type.STRING, Value.of(""))
        .effect(Effect.COMPUTES)
        .does(AssertionBuiltins::contains);
    TestBuiltins.declare(builtins, "fail", SECTION)
        .doc("Fails the test.")
        .takes("message", Type.STRING, Value.of(""))
        .does(
            call -> {
              throw failure(call, text("testSaysSo"), 0);
            });
    TestBuiltins.declare(builtins, "skip", SECTION)
        .doc("Ends the test, which then counts as skipped.")
        .needs("reason", Type.STRING)
        .does(
            call -> {
              throw new ScriptError(AssertionCodes.SKIPPED, call.text(0));
            });
    TestBuiltins.declare(builtins, "expect_failure", SECTION)
        .doc(
            "From here on the test has to end with an error whose message contains this text; it"
                + " fails if it ends otherwise.")
        .needs("message", Type.STRING)
        .does(
            call -> {
              TestBuiltins.bench(call).expected().failure(call.text(0));
              return call.answer();
            });
  }

  /** What an assertion says that does not hold: the own words of the test first. */
  static ScriptError failure(Call<ControlBox> call, String what, int message) throws ScriptError {
    String own = call.text(message);
    return own.isEmpty()
        ? call.failure(AssertionCodes.FAILED, what)
        : new ScriptError(AssertionCodes.FAILED, own + ": " + what);
  }

  /** A value for a message, never too long. */
  static String shown(Value value) {
    String text = ValueText.shortened(value, MAX_SHOWN);
    return value instanceof StringValue ? '"' + text + '"' : text;
  }

  private static Outcome check(Call<ControlBox> call, boolean holds, String what, int message)
      throws ScriptError {
    if (!holds) {
      throw failure(call, what, message);
    }
    return call.answer();
  }

  private static Outcome equal(Call<ControlBox> call, boolean wanted) throws ScriptError {
    Value actual = call.value(0);
    Value other = call.value(1);
    call.charge(Math.min(actual.sizeBytes(), other.sizeBytes()) / BYTES_A_NS);
    if (Operators.equal(actual, other) != wanted) {
      throw failure(
          call,
          wanted ? text("notEqual", shown(actual), shown(other)) : text("equal", shown(actual)),
          2);
    }
    return call.answer();
  }

  private static Outcome contains(Call<ControlBox> call) throws ScriptError {
    boolean found =
        switch (call.value(0)) {
          case StringValue text -> text.bytes().contains(call.text(1));
          case ListValue list -> has(call, list, call.value(1));
          default -> throw call.wrongKind(0, text("stringOrList"));
        };
    if (!found) {
      throw failure(call, text("notContained", shown(call.value(0)), shown(call.value(1))), 2);
    }
    return call.answer();
  }

  private static boolean has(Call<ControlBox> call, ListValue list, Value element)
      throws ScriptError {
    call.charge(list.sizeBytes() / BYTES_A_NS);
    for (int i = 0; i < list.length(); i++) {
      if (Operators.equal(list.get(i), element)) {
        return true;
      }
    }
    return false;
  }
}
