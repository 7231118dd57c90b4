package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** Tool connector page: how the connector at the tool flange is used. */
final class ToolConnectorPage implements Page {
  private final Editing editing;
  private final TitledCard card =
      new TitledCard("tool-connector", text("toolConnector"), "[grow, fill]");
  private final PartsForm<Wiring> form;

  ToolConnectorPage(Editing editing) {
    this.editing = editing;
    form =
        new PartsForm<>(
            "tool-connector",
            next -> editing.refusal(parts -> parts.wiring = next),
            next -> editing.take(parts -> parts.wiring = next));
    form.<Integer>choice(
            "voltage",
            text("voltage"),
            now -> List.of(0, 12, 24),
            v -> v + " V",
            Wiring::toolVoltage,
            (w, v) -> outputs(w, v, w.toolOutputMode(), w.toolPins()))
        .<ToolOutputMode>choice(
            "outputs",
            text("outputs"),
            now -> List.of(ToolOutputMode.values()),
            mode ->
                switch (mode) {
                  case DIGITAL -> text("digital");
                  case DUAL_PIN_POWER -> text("dualPinPower");
                },
            Wiring::toolOutputMode,
            (w, mode) -> outputs(w, w.toolVoltage(), mode, w.toolPins()));
    for (int i = 0; i < 2; i++) {
      int pin = i;
      form.<ToolPinMode>choice(
          "output-" + i,
          text("output", i),
          now -> List.of(ToolPinMode.values()),
          ToolConnectorPage::words,
          now -> now.toolPins().get(pin),
          (w, mode) -> {
            List<ToolPinMode> pins = new ArrayList<>(w.toolPins());
            pins.set(pin, mode);
            return outputs(w, w.toolVoltage(), w.toolOutputMode(), pins);
          });
    }
    addLine();
    card.add(form.component());
  }

  private void addLine() {
    form.heading(text("serialLine"))
        .check(
            "on",
            text("on"),
            now -> now.toolCommunication().enabled(),
            (w, on) ->
                line(
                    w,
                    c ->
                        new ToolCommunication(
                            on,
                            c.baudRate(),
                            c.parity(),
                            c.stopBits(),
                            c.rxIdleChars(),
                            c.txIdleChars())))
        .<Integer>choice(
            "baud-rate",
            text("baudRate"),
            now -> ToolCommunication.BAUD_RATES,
            String::valueOf,
            now -> now.toolCommunication().baudRate(),
            (w, rate) ->
                line(
                    w,
                    c ->
                        new ToolCommunication(
                            c.enabled(),
                            rate,
                            c.parity(),
                            c.stopBits(),
                            c.rxIdleChars(),
                            c.txIdleChars())))
        .<ToolCommunication.Parity>choice(
            "parity",
            text("parity"),
            now -> List.of(ToolCommunication.Parity.values()),
            parity ->
                switch (parity) {
                  case NONE -> text("noParity");
                  case ODD -> text("odd");
                  case EVEN -> text("even");
                },
            now -> now.toolCommunication().parity(),
            (w, parity) ->
                line(
                    w,
                    c ->
                        new ToolCommunication(
                            c.enabled(),
                            c.baudRate(),
                            parity,
                            c.stopBits(),
                            c.rxIdleChars(),
                            c.txIdleChars())))
        .<Integer>choice(
            "stop-bits",
            text("stopBits"),
            now -> List.of(1, 2),
            String::valueOf,
            now -> now.toolCommunication().stopBits(),
            (w, bits) ->
                line(
                    w,
                    c ->
                        new ToolCommunication(
                            c.enabled(),
                            c.baudRate(),
                            c.parity(),
                            bits,
                            c.rxIdleChars(),
                            c.txIdleChars())))
        .numberRow(
            "rx-idle-characters",
            text("rxIdleCharacters"),
            Measure.PLAIN,
            now -> now.toolCommunication().rxIdleChars(),
            (w, chars) ->
                line(
                    w,
                    c ->
                        new ToolCommunication(
                            c.enabled(),
                            c.baudRate(),
                            c.parity(),
                            c.stopBits(),
                            chars.floatValue(),
                            c.txIdleChars())))
        .numberRow(
            "tx-idle-characters",
            text("txIdleCharacters"),
            Measure.PLAIN,
            now -> now.toolCommunication().txIdleChars(),
            (w, chars) ->
                line(
                    w,
                    c ->
                        new ToolCommunication(
                            c.enabled(),
                            c.baudRate(),
                            c.parity(),
                            c.stopBits(),
                            c.rxIdleChars(),
                            chars.floatValue())));
  }

  private static Wiring outputs(
      Wiring w, int voltage, ToolOutputMode mode, List<ToolPinMode> pins) {
    return new Wiring(
        w.analogIn(), w.analogOut(), w.toolAnalogIn(), voltage, mode, pins, w.toolCommunication());
  }

  private static Wiring line(Wiring w, UnaryOperator<ToolCommunication> change) {
    return new Wiring(
        w.analogIn(),
        w.analogOut(),
        w.toolAnalogIn(),
        w.toolVoltage(),
        w.toolOutputMode(),
        w.toolPins(),
        change.apply(w.toolCommunication()));
  }

  private static String words(ToolPinMode mode) {
    return switch (mode) {
      case SINKING -> text("sinkingNpn");
      case SOURCING -> text("sourcingPnp");
      case PUSH_PULL -> text("pushPull");
    };
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    form.show(editing.now().wiring());
  }
}
