package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.Popup;
import org.pendant.script.vm.Machine;

/** Handler of popups, questions and the log. */
final class MessageCommandHandler implements CommandHandler<MessageCommand> {
  private final ControlBox box;
  private final Machine machine;

  MessageCommandHandler(ControlBox box, Machine machine) {
    this.box = box;
    this.machine = machine;
  }

  @Override
  public Class<MessageCommand> family() {
    return MessageCommand.class;
  }

  @Override
  public Reply carryOut(MessageCommand command) {
    return switch (command) {
      case MessageCommand.AnswerPopup(long number) -> answerPopup(number);
      case MessageCommand.AnswerQuestion(long number, Answer answer) -> {
        box.prompts().questions().answer(number, answer);
        yield Reply.done();
      }
      case MessageCommand.CancelQuestion(long number) -> {
        box.prompts().questions().cancel(number);
        machine.stop();
        yield Reply.done();
      }
      case MessageCommand.ShowPopup(String title, String text) -> {
        box.prompts()
            .popups()
            .show(box.clock().timeS(), title, text, Popup.Severity.MESSAGE, false);
        yield Reply.done();
      }
      case MessageCommand.WriteLog(Level level, String text) -> {
        box.log().protocol(level, text);
        yield Reply.done();
      }
    };
  }

  private Reply answerPopup(long number) {
    boolean blocked = box.prompts().popups().blocked();
    if (!box.prompts().popups().answer(number)) {
      return new Reply.Refused(Refusal.Code.UNKNOWN, text("popupNotOpen", number));
    }
    if (blocked && !box.prompts().popups().blocked() && box.safety().programRefusal().isEmpty()) {
      machine.resume();
    }
    return Reply.done();
  }
}
