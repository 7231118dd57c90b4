package org.pendant.desktop.io;

import java.util.EnumMap;
import java.util.Map;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.kit.layout.TitledCard;

/** Safety card: the inputs that demand safety functions. */
final class SafetyCard {
  private final TitledCard card = new TitledCard("Safety inputs", "[][grow,fill]");
  private final Map<SafetyInput, LevelButton> buttons = new EnumMap<>(SafetyInput.class);
  private final IoPresenter presenter;

  SafetyCard(IoPresenter presenter) {
    this.presenter = presenter;
    for (SafetyInput input : SafetyInput.values()) {
      LevelButton button =
          TitledCard.named(
              new LevelButton(LevelIcon.ALARM, () -> presenter.toggle(input)),
              "safety-" + input.word().replace('_', '-'),
              "Demand: " + title(input));
      JLabel label = new JLabel(title(input));
      label.setLabelFor(button);
      label.setToolTipText(meaning(input));
      buttons.put(input, button);
      card.add(button);
      card.add(label);
    }
  }

  private static String title(SafetyInput input) {
    return switch (input) {
      case EMERGENCY_STOP -> "Emergency stop";
      case SYSTEM_EMERGENCY_STOP -> "System emergency stop";
      case SAFEGUARD_STOP -> "Safeguard stop";
      case AUTOMATIC_MODE_SAFEGUARD_STOP -> "Automatic mode safeguard";
      case REDUCED_MODE -> "Reduced mode";
    };
  }

  private static String meaning(SafetyInput input) {
    return switch (input) {
      case EMERGENCY_STOP -> "The emergency stop button of the robot is pressed";
      case SYSTEM_EMERGENCY_STOP -> "The machines around demand an emergency stop";
      case SAFEGUARD_STOP -> "A person is near: the arm waits";
      case AUTOMATIC_MODE_SAFEGUARD_STOP -> "A person is near in automatic mode: the arm waits";
      case REDUCED_MODE -> "The reduced limits hold";
    };
  }

  JComponent component() {
    return card;
  }

  void refresh() {
    buttons.forEach((input, button) -> button.showLevel(presenter.active(input)));
  }
}
