package org.pendant.gui.io;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextField;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.gui.layout.Card;

/** The signals of one group, a row each: level, name and, for inputs, a button for a pulse. */
final class SignalCard {
  private final Card card;
  private final IoPresenter presenter;
  private final SignalLabels labels;
  private final List<Runnable> rows = new ArrayList<>();

  SignalCard(SignalBank bank, IoPresenter presenter, SignalLabels labels) {
    this.presenter = presenter;
    this.labels = labels;
    card =
        new Card(
            SignalName.of(bank),
            bank.input() ? "[][][grow,fill,110::][]" : "[][][grow,fill,110::]");
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
        Card.named(
            new LevelButton(LevelIcon.Form.SWITCH, () -> presenter.toggle(signal)),
            SignalName.id(signal),
            "Force " + signal + ", in scripts " + SignalName.inScript(signal));
    JButton pulse =
        Card.named(
            new JButton("Pulse"),
            SignalName.id(signal) + "-pulse",
            "Change " + signal + " for the length of a pulse");
    pulse.putClientProperty("JButton.buttonType", "toolBarButton");
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
    Lamp lamp = new Lamp(signal);
    card.add(lamp, "h 22!");
    addNames(signal);
    rows.add(() -> lamp.showLevel(presenter.level(signal)));
  }

  private void addNames(Signal signal) {
    JLabel brief = new JLabel(SignalName.brief(signal));
    brief.putClientProperty("FlatLaf.styleClass", "monospaced");
    brief.setToolTipText("In scripts " + SignalName.inScript(signal));
    card.add(brief);
    JTextField label =
        Card.named(
            new JTextField(labels.of(signal)),
            SignalName.id(signal) + "-label",
            "Your name for " + signal);
    label.putClientProperty("JTextField.placeholderText", "Name");
    label.putClientProperty(
        "FlatLaf.style", "borderColor: $Card.fieldBorder; background: null; arc: 8");
    label.addActionListener(event -> labels.name(signal, label.getText()));
    label.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            labels.name(signal, label.getText());
          }
        });
    card.add(label);
  }
}
