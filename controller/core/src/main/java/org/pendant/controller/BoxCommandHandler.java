package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.Locale;
import java.util.Optional;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.InputOwners;

/** Handler of the commands to the control box as a whole. */
final class BoxCommandHandler implements CommandHandler<BoxCommand> {
  private final ControlBox box;

  BoxCommandHandler(ControlBox box) {
    this.box = box;
  }

  @Override
  public Class<BoxCommand> family() {
    return BoxCommand.class;
  }

  @Override
  public Reply carryOut(BoxCommand command) {
    return switch (command) {
      case BoxCommand.ShutDown _ -> {
        box.safety().shutDown();
        yield Reply.done();
      }
      case BoxCommand.NoteLostTime(double behindS, boolean told) -> {
        noteLostTime(behindS, told);
        yield Reply.done();
      }
      case BoxCommand.SetSpeedFraction(String writer, double fraction) ->
          Reply.unless(setSpeed(writer, fraction));
    };
  }

  private void noteLostTime(double behindS, boolean told) {
    if (box.clock().fellBehind(behindS) && told) {
      box.log().warning(text("robotTimeBehind", String.format(Locale.ROOT, "%.2f", behindS)));
    }
  }

  private Optional<Refusal> setSpeed(String writer, double fraction) {
    Optional<Refusal> refusal = box.signals().owners().refusal(InputOwners.SPEED_SLIDER, writer);
    if (refusal.isEmpty()) {
      box.motion().setSpeedFraction(fraction);
    }
    return refusal;
  }
}
