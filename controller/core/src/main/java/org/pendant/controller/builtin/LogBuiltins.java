package org.pendant.controller.builtin;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.message.OpenPopups;
import org.pendant.controller.message.Popup;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Log lines and popups (manual 16.41, 16.63). */
final class LogBuiltins {
  private static final String MODULE = "internals";

  /** A line of the log, and all who are told of it. */
  private static final int LINE_NS = 2000;

  private static final int POPUP_NS = 10_000;
  private static final int BYTES_A_NS = 4;
  private static final Optional<Value> DONE = Optional.of(NoneValue.NONE);

  private LogBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("popup")
        .manual(MODULE, "16.41")
        .doc("Shows a message window. A blocking one pauses the program until it is answered.")
        .needs("s", Type.ANY)
        .takes("title", Type.STRING, Value.of("Popup"))
        .takes("warning", Type.BOOL, Value.of(false))
        .takes("error", Type.BOOL, Value.of(false))
        .takes("blocking", Type.BOOL, Value.of(false))
        .costs(POPUP_NS)
        .does(LogBuiltins::popup);
    builtins
        .declare("textmsg")
        .manual(MODULE, "16.63")
        .doc("Writes two values of any type to the log, as one line without a blank between.")
        .needs("s1", Type.ANY)
        .takes("s2", Type.ANY, Value.of(""))
        .effect(Effect.TELLS)
        .costs(LINE_NS)
        .does(LogBuiltins::textmsg);
    builtins
        .declare("varmsg")
        .manual(MODULE, "16.63")
        .doc("Writes the name and the value of a variable to the log, as older software did.")
        .needs("name", Type.STRING)
        .needs("value", Type.ANY)
        .effect(Effect.TELLS)
        .costs(LINE_NS)
        .deprecated("textmsg")
        .does(LogBuiltins::varmsg);
  }

  private static Outcome popup(Call<ControlBox> call) throws ScriptError {
    return call.withText(text -> popup(call, text), 0);
  }

  private static Outcome popup(Call<ControlBox> call, String text) throws ScriptError {
    Popup.Severity severity = Popup.Severity.MESSAGE;
    if (call.bool(3)) {
      severity = Popup.Severity.ERROR;
    } else if (call.bool(2)) {
      severity = Popup.Severity.WARNING;
    }
    OpenPopups board = call.host().prompts().popups();
    boolean blocking = call.bool(4);
    Popup popup = board.show(call.host().clock().timeS(), call.text(1), text, severity, blocking);
    if (!blocking) {
      return call.answer();
    }
    return new Answer(board, popup);
  }

  /** Waits until the popup is answered; the frame loop pauses the program as long as it is open. */
  private record Answer(OpenPopups board, Popup popup) implements Wait {
    @Override
    public Optional<Value> poll(long frame) {
      return board.isOpen(popup) ? Optional.empty() : DONE;
    }

    @Override
    public void cancel() {
      board.answer(popup.number());
    }
  }

  private static Outcome textmsg(Call<ControlBox> call) throws ScriptError {
    return call.withText(
        text -> {
          call.charge(text.length() / BYTES_A_NS);
          call.host().log().script(text);
          return call.answer();
        },
        0,
        1);
  }

  private static Outcome varmsg(Call<ControlBox> call) throws ScriptError {
    String name = call.text(0);
    return call.withText(
        value -> {
          call.charge((name.length() + value.length()) / BYTES_A_NS);
          call.host().log().info(name + " = " + value);
          return call.answer();
        },
        1);
  }
}
