package org.pendant.desktop.move;

import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.pendant.controller.jog.JogDirection;
import org.pendant.controller.jog.JogDirection.Kind;
import org.pendant.kit.form.HoldButton;

/**
 * Jog keys: move the tool while a button of the pads has the focus. A key that repeats is one
 * press; so is one whose Shift is let go first.
 */
final class JogKeys {
  private final JogPresenter presenter;
  private final List<HoldButton> buttons;
  private String held = "";

  /** Keys belong to the pads alone: in sliders and fields they do what they do everywhere. */
  static void bindTo(List<HoldButton> buttons, JogPresenter presenter) {
    var _ = new JogKeys(presenter, buttons);
  }

  private JogKeys(JogPresenter presenter, List<HoldButton> buttons) {
    this.presenter = presenter;
    this.buttons = List.copyOf(buttons);
    bind("RIGHT", 'X', 1);
    bind("LEFT", 'X', -1);
    bind("UP", 'Y', 1);
    bind("DOWN", 'Y', -1);
    bind("PAGE_UP", 'Z', 1);
    bind("PAGE_DOWN", 'Z', -1);
    FocusAdapter stop =
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            left(event);
          }
        };
    buttons.forEach(each -> each.addFocusListener(stop));
  }

  /** From one button of the pads to the next a step may come to its end. */
  private void left(FocusEvent event) {
    held = "";
    if (event.getOppositeComponent() instanceof HoldButton) {
      presenter.letGo();
    } else {
      presenter.release();
    }
  }

  private void bind(String key, char axis, int sign) {
    JogDirection move = Pad.direction(Kind.ALONG, axis, sign);
    JogDirection turn = Pad.direction(Kind.AROUND, axis, sign);
    bind(key, () -> press(key, move));
    bind("shift " + key, () -> press(key, turn));
    bind("released " + key, () -> letGo(key));
    bind("shift released " + key, () -> letGo(key));
  }

  private void press(String key, JogDirection direction) {
    if (!key.equals(held)) {
      held = key;
      presenter.move(direction);
    }
  }

  private void letGo(String key) {
    if (key.equals(held)) {
      held = "";
    }
    presenter.letGo();
  }

  private void bind(String key, Runnable run) {
    for (HoldButton button : buttons) {
      button.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(key), key);
      button
          .getActionMap()
          .put(
              key,
              new AbstractAction() {
                private static final long serialVersionUID = 1L;

                @Override
                public void actionPerformed(ActionEvent event) {
                  run.run();
                }
              });
    }
  }
}
