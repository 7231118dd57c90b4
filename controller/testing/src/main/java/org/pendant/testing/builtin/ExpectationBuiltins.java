package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.Optional;
import org.pendant.controller.bench.TestBench;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Expectations over time. What a test writes as {@code eventually(condition, within=2)} is made
 * into a loop that evaluates the condition in every frame; the loop calls the functions with a
 * {@code $} in their names, which no text can.
 */
public final class ExpectationBuiltins {
  /** The number of the frame in which a time is up: takes the time. */
  public static final String DEADLINE = "$deadline";

  /** Waits for the next frame, or fails when the time is up: takes the deadline and texts. */
  public static final String AWAIT = "$await";

  /**
   * Whether a condition must still hold: takes the deadline, below 0 for the end of the program.
   */
  public static final String STILL = "$still";

  /** Fails as a condition did not hold: takes texts. */
  public static final String BROKEN = "$broken";

  /** The number of the test that is to run; made lines call it. */
  public static final String TEST_NUMBER = "test_number";

  /** What a test file says to have the functions of another file; no call, but replaced. */
  public static final String IMPORT = "import_script";

  /** How long an expectation waits where the test does not say, s. */
  public static final double USUAL_S = 5;

  private static final String SECTION = "Expectations over time";
  private static final Optional<Value> DONE = Optional.of(NoneValue.NONE);

  private ExpectationBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "eventually", SECTION)
        .doc(
            "Waits until a condition holds, which is evaluated in every frame; fails the test if it"
                + " does not within some time.")
        .needs("condition", Type.BOOL)
        .takes("within", Unit.SECOND, USUAL_S)
        .takes("message", Type.STRING, Value.of(""))
        .physicalTime()
        .does(ExpectationBuiltins::replaced);
    TestBuiltins.declare(builtins, "always", SECTION)
        .doc(
            "Evaluates a condition in every frame for some time, or until the program under test"
                + " has ended; fails the test as soon as it does not hold.")
        .needs("condition", Type.BOOL)
        .mayTake("during", Type.NUMBER, Unit.SECOND, "until the program has ended")
        .takes("message", Type.STRING, Value.of(""))
        .physicalTime()
        .does(ExpectationBuiltins::replaced);
    TestBuiltins.declare(builtins, "never", SECTION)
        .doc("As always, of a condition that must not hold.")
        .needs("condition", Type.BOOL)
        .mayTake("during", Type.NUMBER, Unit.SECOND, "until the program has ended")
        .takes("message", Type.STRING, Value.of(""))
        .physicalTime()
        .does(ExpectationBuiltins::replaced);
    TestBuiltins.declare(builtins, IMPORT, "Test files")
        .doc(
            "Makes the functions of a script callable by the tests of this file, also those inside"
                + " its program. Stands outside of functions; its name counts from the folder of"
                + " the test.")
        .needs("file", Type.STRING)
        .does(
            call -> {
              throw call.failure("not-a-statement", text("outsideOfFunctions"));
            });
    declareParts(builtins);
  }

  private static void declareParts(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, TEST_NUMBER, SECTION)
        .doc("The number of the test that is to run.")
        .returns(Type.INT)
        .effect(Effect.ASKS)
        .does(call -> call.answerInt(TestBuiltins.bench(call).testNumber()));
    TestBuiltins.declare(builtins, DEADLINE, SECTION)
        .doc("The frame in which a time is up.")
        .needs("s", Unit.SECOND)
        .returns(Type.NUMBER)
        .does(ExpectationBuiltins::deadline);
    TestBuiltins.declare(builtins, AWAIT, SECTION)
        .doc("Waits for the next frame, until a deadline.")
        .needs("deadline", Type.NUMBER)
        .needs("condition", Type.STRING)
        .needs("message", Type.STRING)
        .physicalTime()
        .does(ExpectationBuiltins::await);
    TestBuiltins.declare(builtins, STILL, SECTION)
        .doc("Whether a deadline is not reached.")
        .needs("deadline", Type.NUMBER)
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(ExpectationBuiltins::still);
    TestBuiltins.declare(builtins, BROKEN, SECTION)
        .doc("Fails the test.")
        .needs("expectation", Type.STRING)
        .needs("condition", Type.STRING)
        .needs("message", Type.STRING)
        .does(ExpectationBuiltins::broken);
  }

  private static Outcome replaced(Call<ControlBox> call) throws ScriptError {
    throw call.failure("not-a-statement", text("asStatement"));
  }

  private static Outcome deadline(Call<ControlBox> call) throws ScriptError {
    double seconds = call.number(0);
    if (!(seconds >= 0)) {
      throw call.refuse(0, text("notNegative"));
    }
    return call.answer((double) (call.frame() + FrameTime.framesFor(seconds)));
  }

  private static Outcome await(Call<ControlBox> call) throws ScriptError {
    if (call.frame() >= call.number(0)) {
      throw said(call, 2, "eventually", text("notTrueInTime", call.text(1)));
    }
    long next = call.frame() + 1;
    Wait wait = frame -> frame >= next ? DONE : Optional.empty();
    return wait;
  }

  private static Outcome still(Call<ControlBox> call) throws ScriptError {
    double deadline = call.number(0);
    TestBench bench = TestBuiltins.bench(call);
    if (deadline >= 0) {
      return call.answer(call.frame() < deadline);
    }
    if (!bench.started()) {
      throw new ScriptError("no-program", text("needDuring"));
    }
    return call.answer(bench.running());
  }

  private static Outcome broken(Call<ControlBox> call) throws ScriptError {
    boolean never = call.text(0).equals("never");
    throw said(call, 2, call.text(0), text(never ? "becameTrue" : "notTrueAnyMore", call.text(1)));
  }

  private static ScriptError said(Call<ControlBox> call, int message, String who, String what)
      throws ScriptError {
    String own = call.text(message);
    return new ScriptError(
        AssertionCodes.FAILED, own.isEmpty() ? who + ": " + what : own + ": " + what);
  }
}
