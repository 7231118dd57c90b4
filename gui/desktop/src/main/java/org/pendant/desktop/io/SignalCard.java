package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingConstants;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.kit.layout.TitledCard;

/**
 * Signal card: the signals of one group, a row each: level, name and, for inputs, a button for a
 * pulse.
 */
final class SignalCard {
  private final TitledCard card;
  private final IoPresenter presenter;
  private final SignalLabels labels;
  private final List<Runnable> rows = new ArrayList<>();

  SignalCard(SignalBank bank, IoPresenter presenter, SignalLabels labels) {
    this.presenter = presenter;
    this.labels = labels;
    card =
        new TitledCard(
            bank.text().replace('_', '-'), SignalName.of(bank), "[][][grow,fill,110::][]");
    for (int i = 0; i < bank.size(); i++) {
      if (bank.input()) {
        addInput(new Signal(bank, i));
      } else {
        addOutput(new Signal(bank, i));
      }
    }
  }

  JComponent component() {
    return card;
  }

  void refresh() {
    rows.forEach(Runnable::run);
  }

  private void addInput(Signal signal) {
    LevelButton level =
        TitledCard.named(
            new LevelButton(LevelIcon.SWITCH, () -> presenter.toggle(signal)),
            SignalName.id(signal),
            text("forceInScripts", signal, SignalName.inScript(signal)));
    JButton pulse =
        TitledCard.named(
            pulseButton(), SignalName.id(signal) + "-pulse", text("changeForTheLengthOfA", signal));
    pulse.addActionListener(event -> presenter.pulse(signal));
    card.add(level);
    addNames(signal);
    card.add(pulse);
    rows.add(
        () -> {
          level.showLevel(presenter.level(signal));
          if (pulse.isEnabled() == presenter.pulsing(signal)) {
            pulse.setEnabled(!presenter.pulsing(signal));
          }
        });
  }

  private void addOutput(Signal signal) {
    LevelButton level =
        TitledCard.named(
            new LevelButton(LevelIcon.SWITCH, () -> presenter.toggle(signal)),
            SignalName.id(signal),
            text("setWhileNoProgramRunsIn", signal, SignalName.inScript(signal)));
    level.showLampWhenDisabled();
    card.add(level);
    addNames(signal);
    // as high and as wide as the row of an input, so that inputs and outputs stand side by side
    JButton space = pulseButton();
    space.setVisible(false);
    card.add(space, "hidemode 0");
    rows.add(
        () -> {
          level.showLevel(presenter.level(signal));
          level.allow(presenter.settable(signal));
        });
  }

  private static JButton pulseButton() {
    JButton button = new JButton(text("pulse"));
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    return button;
  }

  private void addNames(Signal signal) {
    JLabel brief = new JLabel(SignalName.brief(signal));
    brief.putClientProperty("FlatLaf.styleClass", "monospaced");
    brief.setToolTipText(text("inScripts", SignalName.inScript(signal)));
    card.add(brief);
    if (signal.bank().input()) {
      brief.setHorizontalTextPosition(SwingConstants.LEADING);
      rows.add(() -> ForcedMark.show(brief, presenter.forcing().forced(signal.toString())));
    }
    card.add(NameField.of(labels, SignalName.id(signal), signal.toString()));
  }
}
