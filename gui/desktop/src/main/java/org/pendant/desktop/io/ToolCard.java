package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.function.IntConsumer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.io.ToolConnector;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.layout.TitledCard;
import org.pendant.script.vm.ProgramState;

/** Tool card: how the connector at the tool flange is set up, and what it takes. */
final class ToolCard {
  private static final List<Integer> VOLTS = List.of(0, 12, 24);

  private final TitledCard card =
      new TitledCard("tool-connector", text("toolConnector"), "[][grow,fill,110::]");
  private final Forcing forcing;
  private final JComboBox<String> voltage;
  private final JComboBox<String> mode;
  private final List<JComboBox<String>> pins;
  private final JLabel current = new JLabel("\u2013");
  private final JLabel line = new JLabel("\u2013");
  private boolean showing;

  ToolCard(Forcing forcing) {
    this.forcing = forcing;
    voltage =
        choice(
            text("voltage"),
            "tool-voltage",
            List.of("0 V", "12 V", "24 V"),
            chosen -> forcing.write(new SignalWrite.ToolVoltage(VOLTS.get(chosen))));
    current.putClientProperty("FlatLaf.styleClass", "monospaced");
    current.setName("tool-current");
    card.add(new JLabel(text("current")));
    card.add(current, "h 22::");
    mode =
        choice(
            text("outputPins"),
            "tool-output-mode",
            List.of(text("digitalOutputsMode"), text("dualPinPower")),
            chosen ->
                forcing.write(
                    new SignalWrite.ToolOutputs(
                        chosen == 0 ? ToolOutputMode.DIGITAL : ToolOutputMode.DUAL_PIN_POWER)));
    pins = List.of(pin(0), pin(1));
    line.setName("tool-line");
    card.add(new JLabel(text("serialLine")));
    card.add(line, "wmin 0, h 22::");
  }

  private JComboBox<String> pin(int index) {
    return choice(
        text("output", index),
        "tool-digital-output-mode-" + index,
        List.of(text("sinkingNpn"), text("sourcingPnp"), text("pushPull")),
        chosen -> forcing.write(new SignalWrite.ToolPin(index, ToolPinMode.of(chosen + 1))));
  }

  private JComboBox<String> choice(
      String title, String name, List<String> texts, IntConsumer choose) {
    JComboBox<String> box = new JComboBox<>(texts.toArray(String[]::new));
    TitledCard.named(box, name, text("ofTheToolConnector", title));
    box.addActionListener(
        event -> {
          if (!showing) {
            choose.accept(box.getSelectedIndex());
          }
        });
    JLabel label = new JLabel(title);
    label.setLabelFor(box);
    card.add(label);
    card.add(box, "wmin 0");
    return box;
  }

  JComponent component() {
    return card;
  }

  void refresh(ControllerState state) {
    ToolConnector tool = state.signals().tool();
    boolean settable = state.program().state() == ProgramState.STOPPED;
    showing = true;
    show(
        voltage,
        settable,
        VOLTS.indexOf(
            forcing
                .asked(SignalWrite.ToolVoltage.class, SignalWrite.ToolVoltage.NAME)
                .map(SignalWrite.ToolVoltage::voltageV)
                .orElse(tool.voltageV())));
    show(
        mode,
        settable,
        forcing
                    .asked(SignalWrite.ToolOutputs.class, SignalWrite.ToolOutputs.NAME)
                    .map(SignalWrite.ToolOutputs::mode)
                    .orElse(tool.outputMode())
                == ToolOutputMode.DIGITAL
            ? 0
            : 1);
    for (int i = 0; i < SignalBank.TOOL_OUT.size(); i++) {
      SignalWrite.ToolPin now = new SignalWrite.ToolPin(i, tool.pin(i));
      SignalWrite.ToolPin shown = forcing.asked(SignalWrite.ToolPin.class, now.name()).orElse(now);
      show(pins.get(i), settable, shown.mode().number() - 1);
    }
    showing = false;
    String text = String.format(Locale.ROOT, "%.3f A", state.readings().toolCurrentA());
    if (!current.getText().equals(text)) {
      current.setText(text);
    }
    String words = words(tool.communication());
    if (!line.getText().equals(words)) {
      line.setText(words);
      line.setToolTipText(
          tool.communication().enabled()
              ? text("itsWiresAreThoseOfThe", words)
              : text("programsTurnItOnBySet"));
    }
  }

  /** The serial line in words. */
  static String words(ToolCommunication line) {
    if (!line.enabled()) {
      return text("lineOff");
    }
    String parity =
        switch (line.parity()) {
          case NONE -> text("noParity");
          case ODD -> text("oddParity");
          case EVEN -> text("evenParity");
        };
    return text(
        "lineWords",
        line.baudRate(),
        parity,
        line.stopBits() == 1 ? text("oneStopBit") : text("stopBits", line.stopBits()));
  }

  private static void show(JComboBox<String> box, boolean settable, int chosen) {
    if (!box.isPopupVisible() && box.getSelectedIndex() != chosen) {
      box.setSelectedIndex(chosen);
    }
    if (box.isEnabled() != settable) {
      box.setEnabled(settable);
    }
  }
}
