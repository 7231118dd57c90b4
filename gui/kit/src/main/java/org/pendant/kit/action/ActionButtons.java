package org.pendant.kit.action;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Action buttons: buttons that take turns, such as Run, Pause and Stop. Keys on one that can no
 * longer be pressed go to the first that can, also when that is a moment later, unless people send
 * them elsewhere meanwhile: the space bar runs, pauses and resumes.
 */
public final class ActionButtons {
  private final List<ActionButton> buttons;

  /** The one whose keys wait for one that can be pressed. */
  private Optional<ActionButton> left = Optional.empty();

  /** What has the keys meanwhile; empty until that is known. */
  private Optional<Component> meanwhile = Optional.empty();

  /** Those in {@code buttons}, the first choice first. */
  public ActionButtons(List<ActionButton> buttons) {
    this.buttons = List.copyOf(buttons);
  }

  /** Shows of each whether it can be done now. */
  public void refresh() {
    Optional<ActionButton> had = buttons.stream().filter(Component::isFocusOwner).findFirst();
    buttons.forEach(ActionButton::refresh);
    if (had.isPresent()) {
      left = had.filter(each -> !each.isEnabled());
      meanwhile = Optional.empty();
    } else if (left.isPresent()) {
      Optional<Component> now =
          Optional.ofNullable(
              KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner());
      left = left.filter(each -> meanwhile.isEmpty() || meanwhile.equals(now));
      meanwhile = now;
    }
    left.flatMap(
            each ->
                Stream.concat(Stream.of(each), buttons.stream())
                    .filter(Component::isEnabled)
                    .findFirst())
        .ifPresent(Component::requestFocusInWindow);
  }
}
