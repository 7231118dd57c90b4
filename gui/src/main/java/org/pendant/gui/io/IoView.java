package org.pendant.gui.io;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.ScrollPaneConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.layout.Card;
import org.pendant.gui.layout.CardSheet;
import org.pendant.gui.layout.Typed;
import org.pendant.gui.workbench.Palette;
import org.pendant.gui.workbench.View;
import org.pendant.gui.workbench.Workbench;

/** The screen of signals and readings. */
public final class IoView implements View {
  private static final String PULSE_SETTING = "io.pulse-s";
  private static final int GAP = 16;
  private static final int WIDEST_CARD = 480;

  private final IoPresenter presenter;
  private final Workbench workbench;
  private final JPanel content = new JPanel(new BorderLayout());
  private final List<SignalCard> signals = new ArrayList<>();
  private final SafetyCard safety;
  private final FlagCard flags;
  private final ReadingsCard readings = new ReadingsCard();

  /** A screen of low signals; {@link #refresh} brings the levels. */
  public IoView(Workbench workbench) {
    this.workbench = workbench;
    PulseTimer pulses = new PulseTimer(workbench.session()::submit);
    workbench.session().addFrameListener(pulses);
    presenter =
        new IoPresenter(
            workbench.session()::submit, pulses, EventQueue::invokeLater, workbench::notify);
    safety = new SafetyCard(presenter);
    flags = new FlagCard(presenter);
    content.setName("io-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(bar(), BorderLayout.NORTH);
    content.add(scroll(cards()), BorderLayout.CENTER);
  }

  private JComponent bar() {
    JPanel bar = new JPanel(new MigLayout("insets 8 16 0 16, gap 8"));
    JTextField length = new JTextField(workbench.settings().get(PULSE_SETTING).orElse("0.5"), 5);
    Card.named(length, "io-pulse-length", "How long a pulse lasts, in seconds of robot time");
    JLabel label = new JLabel("Pulse length");
    label.setLabelFor(length);
    JLabel problem = new JLabel();
    problem.setName("io-pulse-problem");
    readPulse(length, problem);
    length.getDocument().addDocumentListener(new Typed(() -> readPulse(length, problem)));
    bar.add(label);
    bar.add(length);
    bar.add(new JLabel("s"));
    bar.add(problem);
    return bar;
  }

  private void readPulse(JTextField field, JLabel problem) {
    try {
      presenter.setPulseLength(PulseLength.parse(field.getText()));
      workbench.settings().put(PULSE_SETTING, field.getText().strip());
      problem.setText("");
      field.putClientProperty("JComponent.outline", null);
    } catch (IllegalArgumentException e) {
      problem.setText(e.getMessage());
      problem.setForeground(Palette.error());
      field.putClientProperty("JComponent.outline", "error");
    }
  }

  private JPanel cards() {
    SignalLabels labels = new SignalLabels(workbench.settings());
    JPanel cards = new CardSheet(GAP, WIDEST_CARD);
    for (SignalBank bank :
        List.of(
            SignalBank.STANDARD_IN,
            SignalBank.STANDARD_OUT,
            SignalBank.CONFIGURABLE_IN,
            SignalBank.CONFIGURABLE_OUT,
            SignalBank.TOOL_IN,
            SignalBank.TOOL_OUT)) {
      SignalCard card = new SignalCard(bank, presenter, labels);
      signals.add(card);
      cards.add(card.component());
    }
    cards.add(safety.component());
    cards.add(flags.component());
    cards.add(readings.component());
    return cards;
  }

  private static JScrollPane scroll(JPanel cards) {
    JScrollPane scroll =
        new JScrollPane(
            cards,
            ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
            ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    scroll.setName("io-scroll");
    return scroll;
  }

  @Override
  public String id() {
    return "io";
  }

  @Override
  public String title() {
    return "I/O";
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    presenter.take(state);
    signals.forEach(SignalCard::refresh);
    safety.refresh();
    flags.refresh();
    readings.refresh(state);
  }
}
