package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.List;
import org.pendant.controller.bench.PreparedAnswers;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** The operator: what the screen shows and the log says, and what people answer. */
final class OperatorTestBuiltins {
  private static final String SECTION = "The operator";

  /** Bytes that are searched in a nanosecond, roughly. */
  private static final int BYTES_A_NS = 4;

  private OperatorTestBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "answer", SECTION)
        .doc(
            "Prepares the answer to a question whose text contains this one, as an operator types"
                + " it: answer(\"How many\", \"3\"). It comes at once, or a while after the"
                + " question.")
        .needs("question", Type.STRING)
        .needs("value", Type.ANY)
        .takes("after", Unit.SECOND, 0)
        .does(OperatorTestBuiltins::prepare);
    TestBuiltins.declare(builtins, "hold_popups", SECTION)
        .doc(
            "Has popups stay on the screen until close_popup(); else they close at once and a"
                + " program continues.")
        .does(
            call -> {
              TestBuiltins.bench(call).answers().setPopupsStay(true);
              return call.answer();
            });
    TestBuiltins.declare(builtins, "popup_open", SECTION)
        .doc("Whether a popup is on the screen whose text contains this one.")
        .takes("text", Type.STRING, Value.of(""))
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(OperatorTestBuiltins::popupOpen);
    TestBuiltins.declare(builtins, "close_popup", SECTION)
        .doc("Closes the oldest popup on the screen; a program that it pauses continues.")
        .does(OperatorTestBuiltins::close);
    TestBuiltins.declare(builtins, "log_contains", SECTION)
        .doc("Whether a line of the log since the start of the test contains this text.")
        .needs("text", Type.STRING)
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(call -> call.answer(logged(call)));
    TestBuiltins.declare(builtins, "assert_log", SECTION)
        .doc("Fails the test unless a line of the log contains this text.")
        .needs("text", Type.STRING)
        .does(
            call -> {
              if (!logged(call)) {
                throw call.failure(
                    AssertionCodes.FAILED,
                    text("notLogged", AssertionBuiltins.shown(call.value(0))));
              }
              return call.answer();
            });
  }

  private static Outcome prepare(Call<ControlBox> call) throws ScriptError {
    double after = call.number(2);
    if (!(after >= 0)) {
      throw call.refuse(2, text("notNegative"));
    }
    TestBuiltins.bench(call)
        .answers()
        .add(
            call.text(0),
            new PreparedAnswers.Given(call.value(1).text(), FrameTime.framesFor(after)));
    return call.answer();
  }

  private static Outcome popupOpen(Call<ControlBox> call) throws ScriptError {
    String part = call.text(0);
    boolean open =
        call.host().prompts().popups().open().stream()
            .anyMatch(each -> each.text().contains(part) || each.title().contains(part));
    return call.answer(open);
  }

  private static Outcome close(Call<ControlBox> call) throws ScriptError {
    List<Popup> open = call.host().prompts().popups().open();
    if (open.isEmpty()) {
      throw call.failure("no-popup", text("noPopup"));
    }
    TestBuiltins.bench(call).post(new MessageCommand.AnswerPopup(open.getFirst().number()));
    return call.answer();
  }

  private static boolean logged(Call<ControlBox> call) throws ScriptError {
    String part = call.text(0);
    for (LogEntry each : call.host().log().since(0)) {
      call.charge(each.text().length() / BYTES_A_NS + 1);
      if (each.text().contains(part)) {
        return true;
      }
    }
    return false;
  }
}
