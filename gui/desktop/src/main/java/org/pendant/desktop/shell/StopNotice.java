package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.desktop.shell.run.StopCard;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.text.Messages;

/** Stop notice: tells of a stop of the arm while the screen that explains it is not in front. */
final class StopNotice {
  private static final String NAME = "stop-notice";

  private final Notices notices;
  private final Supplier<PoseForm> form;
  private final BooleanSupplier explained;
  private final Runnable explain;
  private Optional<StopCard> told = Optional.empty();

  /**
   * No stop yet.
   *
   * @param form in which units people read numbers
   * @param explained whether people see the screen that explains stops
   * @param explain brings it to the front
   */
  StopNotice(
      Notices notices, Supplier<PoseForm> form, BooleanSupplier explained, Runnable explain) {
    this.notices = notices;
    this.form = form;
    this.explained = explained;
    this.explain = explain;
  }

  /** Tells of each stop once, and takes it back when it is over or explained. */
  void refresh(ControllerState state) {
    Optional<StopCard> card = StopCard.of(state, form.get());
    if (card.isPresent() && explained.getAsBoolean()) {
      notices.close(NAME);
      told = card;
    } else if (!card.equals(told)) {
      notices.close(NAME);
      told = card;
      card.ifPresent(this::tell);
    }
  }

  private void tell(StopCard card) {
    notices.ask(
        NAME,
        Messages.told(card.title(), card.message()),
        List.of(
            new Choice("show-what-happened", text("showWhatHappened"), explain),
            new Choice("close", text("close"), () -> {})));
  }
}
