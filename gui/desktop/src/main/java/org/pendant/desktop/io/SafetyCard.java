package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.util.EnumMap;
import java.util.Map;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.kit.layout.TitledCard;

/** Safety card: the inputs that demand safety functions. */
final class SafetyCard {
  private final TitledCard card =
      new TitledCard("safety-inputs", text("safetyInputs"), "[][grow,fill]");
  private final Map<SafetyInput, LevelButton> buttons = new EnumMap<>(SafetyInput.class);
  private final IoPresenter presenter;

  SafetyCard(IoPresenter presenter) {
    this.presenter = presenter;
    for (SafetyInput input : SafetyInput.values()) {
      LevelButton button =
          TitledCard.named(
              new LevelButton(LevelIcon.ALARM, () -> presenter.toggle(input)),
              "safety-" + input.word().replace('_', '-'),
              text("demand", title(input)));
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
      case EMERGENCY_STOP -> text("emergencyStop");
      case SYSTEM_EMERGENCY_STOP -> text("systemEmergencyStop");
      case SAFEGUARD_STOP -> text("safeguardStop");
      case AUTOMATIC_MODE_SAFEGUARD_STOP -> text("automaticModeSafeguard");
      case REDUCED_MODE -> text("reducedMode");
    };
  }

  private static String meaning(SafetyInput input) {
    return switch (input) {
      case EMERGENCY_STOP -> text("theEmergencyStopButtonOfThe");
      case SYSTEM_EMERGENCY_STOP -> text("theMachinesAroundDemandAnEmergency");
      case SAFEGUARD_STOP -> text("aPersonIsNearTheArm");
      case AUTOMATIC_MODE_SAFEGUARD_STOP -> text("aPersonIsNearInAutomatic");
      case REDUCED_MODE -> text("theReducedLimitsHold");
    };
  }

  JComponent component() {
    return card;
  }

  void refresh() {
    buttons.forEach((input, button) -> button.showLevel(presenter.active(input)));
  }
}
