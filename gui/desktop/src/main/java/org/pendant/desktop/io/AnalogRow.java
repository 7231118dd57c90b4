package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.awt.CardLayout;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JTextField;
import javax.swing.SwingConstants;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/** Analog row: one analog signal in a card: name, value, domain, and a slider below. */
final class AnalogRow {
  private static final int STEPS = 1000;
  private static final String SLIDER = "slider";
  private static final String PROBLEM = "problem";

  private final AnalogPresenter presenter;
  private final JLabel brief;
  private final JTextField value = new JTextField(5);
  private final JComboBox<String> domain = new JComboBox<>();
  private final JSlider slider = new JSlider(0, STEPS);
  private final JLabel problem = new JLabel();
  private final JPanel below = new JPanel(new CardLayout());

  /** Whether the controls are made to show something, which is no wish of the user. */
  private boolean showing;

  AnalogRow(TitledCard card, AnalogBank bank, int index, Forcing forcing, SignalLabels labels) {
    presenter = new AnalogPresenter(bank, index, forcing);
    String id = SignalName.id(bank, index);
    String name = bank.name(index);
    brief = new JLabel(SignalName.brief(bank, index), ForcedMark.of(false), SwingConstants.LEADING);
    brief.setHorizontalTextPosition(SwingConstants.LEADING);
    brief.putClientProperty("FlatLaf.styleClass", "monospaced");
    brief.setToolTipText(text("inScripts", SignalName.inScript(bank, index)));
    for (AnalogDomain each : AnalogDomain.values()) {
      domain.addItem(AnalogText.unit(each));
    }

    TitledCard.named(
        value, id + "-value", text(bank.input() ? "forceByEnter" : "setByEnter", name));
    value.setHorizontalAlignment(SwingConstants.TRAILING);
    value.putClientProperty("FlatLaf.styleClass", "monospaced");
    TitledCard.named(domain, id + "-domain", text("whatIsMadeOfACurrent", name));
    TitledCard.named(slider, id, text(bank.input() ? "forceSignal" : "setSignal", name));
    problem.setName(id + "-problem");
    listen();
    card.add(brief);
    card.add(NameField.of(labels, id, name), "span, growx, wmin 60");
    // in one place, so that nothing moves away below the user who types
    below.setOpaque(false);
    below.add(slider, SLIDER);
    below.add(problem, PROBLEM);
    card.add(below, "skip, growx, w 40:80:");
    card.add(value, "wmin pref");
    card.add(domain, "wmin pref");
  }

  private void listen() {
    value.addActionListener(event -> commit());
    value.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            tell("");
            show();
          }
        });
    value.getDocument().addDocumentListener(new Typed(() -> tell("")));
    slider.addChangeListener(
        event -> {
          if (!showing) {
            presenter.setRatio(slider.getValue() / (double) STEPS);
          }
        });
    domain.addActionListener(
        event -> {
          if (!showing) {
            presenter.setDomain(AnalogDomain.of(domain.getSelectedIndex()));
          }
        });
  }

  private void commit() {
    try {
      presenter.set(value.getText());
      tell("");
      value.selectAll();
    } catch (IllegalArgumentException e) {
      tell(Messages.shown(e.getMessage()));
    }
  }

  private void tell(String text) {
    problem.setText(text);
    problem.setToolTipText(text.isEmpty() ? null : text);
    problem.setForeground(Palette.error());
    ((CardLayout) below.getLayout()).show(below, text.isEmpty() ? SLIDER : PROBLEM);
    value.putClientProperty("JComponent.outline", text.isEmpty() ? null : "error");
  }

  void refresh(ControllerState state) {
    presenter.take(state);
    ForcedMark.show(brief, presenter.forced());
    if (!value.isFocusOwner()) {
      show();
    }
    showing = true;
    if (!slider.getValueIsAdjusting()) {
      slider.setValue((int) Math.round(presenter.valueRatio() * STEPS));
    }
    if (!domain.isPopupVisible()) {
      domain.setSelectedIndex(presenter.domain().number());
    }
    showing = false;
    enable(presenter.settable());
    domain.setEnabled(presenter.domainSettable());
  }

  private void enable(boolean settable) {
    if (slider.isEnabled() != settable) {
      slider.setEnabled(settable);
      value.setEditable(settable);
    }
  }

  private void show() {
    String text = AnalogText.of(presenter.value(), presenter.domain());
    if (!value.getText().equals(text)) {
      value.setText(text);
    }
  }
}
