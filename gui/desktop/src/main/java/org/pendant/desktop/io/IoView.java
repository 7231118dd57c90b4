package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.layout.CardColumns;
import org.pendant.kit.layout.SettledScroll;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.layout.WideContent;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/** I/O view: the screen of signals and readings. */
public final class IoView implements View {
  private static final String PULSE_SETTING = "io.pulse-s";
  private static final String USED_SETTING = "io.only-used";
  private static final int GAP = 16;
  private static final int WIDEST_CARD = 480;

  private final IoPresenter presenter;
  private final Workbench workbench;
  private final JPanel content = new JPanel(new BorderLayout());
  private final List<SignalCard> signals = new ArrayList<>();
  private final SafetyCard safety;
  private final List<AnalogCard> analog = new ArrayList<>();
  private final ToolCard tool;
  private final SignalLabels labels;
  private final List<MemoryCard> memories = new ArrayList<>();
  private final JTextField search = new JTextField(12);
  private final JCheckBox onlyUsed = new JCheckBox(text("onlyRegistersInUse"));
  private final JLabel forced = new JLabel("", ForcedMark.of(false), SwingConstants.LEADING);
  private final JButton release = new JButton(text("releaseAll"));
  private final ModbusCard modbus = new ModbusCard();
  private final DeviceCard devices;
  private final ReadingsCard readings = new ReadingsCard();

  /** A screen of low signals; {@link #refresh} brings the levels. */
  public IoView(Workbench workbench) {
    this(workbench, new SignalLabels(workbench.settings()));
  }

  /**
   * As the other one, with names from elsewhere.
   *
   * @param labels names of signals
   */
  public IoView(Workbench workbench, SignalLabels labels) {
    this.workbench = workbench;
    this.labels = labels;
    PulseTimer pulses = new PulseTimer(workbench.session()::submit);
    workbench.session().addFrameListener(pulses);
    presenter =
        new IoPresenter(
            workbench.session()::submit, pulses, EventQueue::invokeLater, workbench::notify);
    safety = new SafetyCard(presenter);
    devices =
        new DeviceCard(
            workbench.session()::submit,
            workbench::notify,
            () -> FormMemory.read(workbench.settings()).length());
    tool = new ToolCard(presenter.forcing());
    content.setName("io-view");
    content.getAccessibleContext().setAccessibleName(title());
    addActions();
  }

  private JComponent bar() {
    JPanel bar = new JPanel(new WrappingRow(8));
    JTextField length = new JTextField(workbench.settings().get(PULSE_SETTING).orElse("0.5"), 4);
    TitledCard.named(length, "io-pulse-length", text("howLongAPulseLastsIn"));
    JLabel problem = new JLabel();
    problem.setName("io-pulse-problem");
    readPulse(length, problem);
    length.getDocument().addDocumentListener(new Typed(() -> readPulse(length, problem)));
    bar.add(group(labelled(text("pulseLength"), length), length, new JLabel("s"), problem));
    search.putClientProperty("JTextField.placeholderText", text("numberOrName"));
    search.putClientProperty("JTextField.showClearButton", true);
    TitledCard.named(search, "io-register-search", text("findRegistersAndFlagsByNumber"));
    search.getDocument().addDocumentListener(new Typed(this::filter));
    TitledCard.named(onlyUsed, "io-only-used", text("showOnlyRegistersAndFlagsThat"));
    onlyUsed.setSelected(workbench.settings().get(USED_SETTING).map(Boolean::valueOf).orElse(true));
    onlyUsed.addActionListener(
        event -> {
          workbench.settings().put(USED_SETTING, Boolean.toString(onlyUsed.isSelected()));
          filter();
        });
    bar.add(group(labelled(text("register"), search), search, onlyUsed));
    TitledCard.named(release, "io-release-all", text("bringAllForcedInputsToRest"));
    release.addActionListener(event -> presenter.releaseAll());
    forced.setName("io-forced");
    // There also while nothing is forced: the inputs stay under the pointer that forces them.
    bar.add(group(forced, release));
    return bar;
  }

  private static JLabel labelled(String text, JComponent field) {
    JLabel label = new JLabel(text);
    label.setLabelFor(field);
    return label;
  }

  private static JPanel group() {
    return new JPanel(new MigLayout("insets 0 8 0 8, gap 8"));
  }

  private static JPanel group(JComponent... parts) {
    JPanel group = group();
    for (JComponent each : parts) {
      group.add(each);
    }
    return group;
  }

  private void addActions() {
    workbench
        .actions()
        .add(
            new Action(
                "io.release-all",
                text("releaseAllForcedInputs"),
                "",
                () -> presenter.forcing().count() > 0,
                presenter::releaseAll));
    workbench
        .actions()
        .add(
            Action.of(
                "io.find-register",
                text("findARegisterOrFlag"),
                "",
                () -> {
                  workbench.show(id());
                  search.requestFocusInWindow();
                  search.selectAll();
                }));
  }

  private void filter() {
    memories.forEach(each -> each.filter(search.getText(), onlyUsed.isSelected()));
  }

  private void readPulse(JTextField field, JLabel problem) {
    try {
      presenter.setPulseLength(PulseLength.parse(field.getText()));
      workbench.settings().put(PULSE_SETTING, field.getText().strip());
      problem.setText("");
      field.putClientProperty("JComponent.outline", null);
    } catch (IllegalArgumentException e) {
      problem.setText(Messages.shown(e.getMessage()));
      problem.setForeground(Palette.error());
      field.putClientProperty("JComponent.outline", "error");
    }
  }

  private JPanel cards() {
    JPanel cards = new WideContent(new CardColumns(GAP, WIDEST_CARD));
    cards.add(devices.component());
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
    addAnalog(
        cards,
        new AnalogCard(
            "analog-inputs",
            text("analogInputs"),
            List.of(AnalogBank.STANDARD_IN, AnalogBank.TOOL_IN),
            presenter.forcing(),
            labels));
    addAnalog(
        cards,
        new AnalogCard(
            "analog-outputs",
            text("analogOutputs"),
            List.of(AnalogBank.STANDARD_OUT),
            presenter.forcing(),
            labels));
    cards.add(tool.component());
    cards.add(safety.component());
    for (RegisterKind kind : RegisterKind.values()) {
      for (RegisterDirection direction : RegisterDirection.values()) {
        addMemory(cards, new Memory.Registers(direction, kind), labels);
      }
    }
    addMemory(cards, new Memory.Flags(), labels);
    cards.add(modbus.component());
    cards.add(readings.component());
    return cards;
  }

  private void addAnalog(JPanel cards, AnalogCard card) {
    analog.add(card);
    cards.add(card.component());
  }

  private void addMemory(JPanel cards, Memory memory, SignalLabels labels) {
    MemoryCard card = new MemoryCard(memory, presenter.forcing(), labels);
    memories.add(card);
    cards.add(card.component());
  }

  private void showForced() {
    int count = presenter.forcing().count();
    String text =
        switch (count) {
          case 0 -> text("noInputForced");
          case 1 -> text("oneInputForced");
          default -> text("inputsForced", count);
        };
    if (!forced.getText().equals(text)) {
      forced.setText(text);
      ForcedMark.show(forced, count > 0);
      release.setEnabled(count > 0);
    }
  }

  private static JScrollPane scroll(JPanel cards) {
    JScrollPane scroll = new SettledScroll(cards);
    scroll.setName("io-scroll");
    return scroll;
  }

  @Override
  public String id() {
    return "io";
  }

  @Override
  public String title() {
    return text("io");
  }

  @Override
  public JComponent component() {
    if (content.getComponentCount() == 0) {
      content.add(bar(), BorderLayout.NORTH);
      content.add(scroll(cards()), BorderLayout.CENTER);
      filter();
      showForced();
    }
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    presenter.take(state);
    signals.forEach(SignalCard::refresh);
    safety.refresh();
    analog.forEach(each -> each.refresh(state));
    tool.refresh(state);
    memories.forEach(each -> each.refresh(state));
    showForced();
    modbus.refresh(state);
    devices.refresh(state);
    readings.refresh(state);
  }
}
