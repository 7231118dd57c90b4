package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.PendingPrompt;
import org.pendant.controller.message.PromptQueue;
import org.pendant.controller.message.Question;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.Value;

/** Questions to the operator (manual 18.73 to 18.76). */
final class OperatorBuiltins {
  private static final String MODULE = "interfaces";

  private OperatorBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declare(
        builtins,
        "boolean",
        "18.73",
        Question.Kind.BOOLEAN,
        Type.BOOL,
        "Asks the operator for yes or no. Waits for the answer; other threads keep running.");
    declare(
        builtins,
        "float",
        "18.74",
        Question.Kind.FLOAT,
        Type.NUMBER,
        "Asks the operator for a number. Waits for the answer; other threads keep running.");
    declare(
        builtins,
        "integer",
        "18.75",
        Question.Kind.INTEGER,
        Type.NUMBER,
        "Asks the operator for a whole number. Waits for the answer; other threads keep running.");
    declare(
        builtins,
        "string",
        "18.76",
        Question.Kind.STRING,
        Type.STRING,
        "Asks the operator for a text. Waits for the answer; other threads keep running.");
  }

  private static void declare(
      Builtins<ControlBox> builtins,
      String word,
      String section,
      Question.Kind kind,
      Type type,
      String doc) {
    builtins
        .declare("request_" + word + "_from_primary_client")
        .manual(MODULE, section)
        .doc(doc)
        .needs("message", Type.STRING)
        .returns(type)
        .physicalTime()
        .does(call -> ask(call, kind));
  }

  private static Outcome ask(Call<ControlBox> call, Question.Kind kind) throws ScriptError {
    String text = call.text(0);
    if (text.isEmpty()) {
      throw call.failure("value-out-of-range", text("emptyQuestion"));
    }
    PromptQueue board = call.host().prompts().questions();
    PendingPrompt pendingPrompt = board.ask(call.host().clock().timeS(), kind, text);
    if (pendingPrompt.refusal().isPresent()) {
      throw call.failure("no-answer", pendingPrompt.refusal().get());
    }
    return new PromptWait(board, pendingPrompt);
  }

  /** Waits for the answer. */
  private record PromptWait(PromptQueue board, PendingPrompt pendingPrompt) implements Wait {
    @Override
    public Optional<Value> poll(long frame) {
      return pendingPrompt.answer().map(OperatorBuiltins::value);
    }

    @Override
    public void cancel() {
      board.withdraw(pendingPrompt);
    }
  }

  private static Value value(Answer answer) {
    return switch (answer) {
      case Answer.Bool bool -> Value.of(bool.value());
      case Answer.Whole whole -> Value.of(whole.value());
      case Answer.Decimal decimal -> Value.of(decimal.value());
      case Answer.Text text -> new StringValue(text.bytes());
    };
  }
}
