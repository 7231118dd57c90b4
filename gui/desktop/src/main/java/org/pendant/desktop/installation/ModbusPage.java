package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.Measure;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;

/** Modbus page: signals at Modbus devices. */
final class ModbusPage implements Page {
  private static final List<ModbusKind> KINDS =
      Arrays.stream(ModbusKind.values())
          .filter(kind -> kind != ModbusKind.READ_WRITE_REGISTERS)
          .toList();

  private final TitledCard card = new TitledCard("modbus", "Modbus", "[grow, fill]");
  private final Items<ModbusSetup> items;
  private final JLabel value = new JLabel(" ");
  private final JLabel status = new JLabel(" ");

  ModbusPage(Editing editing) {
    items =
        new Items<>(
            "modbus",
            text("modbusSignals"),
            text("noSignalYetASignalAt"),
            new Listed<>(editing, Installation::modbus, (parts, all) -> parts.modbus = all),
            each ->
                text("signalAt", each.name(), each.device(), each.kind().words(), each.address()));
    items.adder("add-signal", text("addSignal"), () -> fresh(editing.now()));
    items
        .form()
        .text(
            "name",
            text("name"),
            ModbusSetup::name,
            (m, name) ->
                new ModbusSetup(
                    name.strip(), m.device(), m.unit(), m.kind(), m.address(), m.updateHz()))
        .text(
            "device",
            text("device"),
            ModbusSetup::device,
            (m, device) ->
                new ModbusSetup(
                    m.name(), device.strip(), m.unit(), m.kind(), m.address(), m.updateHz()))
        .numberRow(
            "unit",
            text("unit"),
            Measure.COUNT,
            ModbusSetup::unit,
            (m, unit) ->
                new ModbusSetup(
                    m.name(), m.device(), whole(unit), m.kind(), m.address(), m.updateHz()))
        .<ModbusKind>choice(
            "kind",
            text("kind"),
            now -> KINDS,
            kind -> capital(Messages.shown(kind.words())),
            ModbusSetup::kind,
            (m, kind) ->
                new ModbusSetup(m.name(), m.device(), m.unit(), kind, m.address(), m.updateHz()))
        .numberRow(
            "address",
            text("address"),
            Measure.COUNT,
            ModbusSetup::address,
            (m, address) ->
                new ModbusSetup(
                    m.name(), m.device(), m.unit(), m.kind(), whole(address), m.updateHz()))
        .numberRow(
            "rate",
            text("rate"),
            Measure.HERTZ,
            ModbusSetup::updateHz,
            (m, hz) ->
                new ModbusSetup(m.name(), m.device(), m.unit(), m.kind(), m.address(), whole(hz)))
        .add(text("valueNow"), value)
        .add(text("state"), status)
        .note(text("aDeviceIsAnAddressWith"));
    value.setName("modbus-value");
    status.setName("modbus-state");
    card.add(items.component());
  }

  private static int whole(double number) {
    if (number != Math.rint(number)) {
      throw new IllegalArgumentException(text("itIsMustBeAWhole", number));
    }
    return (int) number;
  }

  private ModbusSetup fresh(Installation now) {
    String device = now.modbus().isEmpty() ? "127.0.0.1" : now.modbus().getLast().device();
    return new ModbusSetup(items.freshName("MODBUS"), device, 1, ModbusKind.DIGITAL_OUTPUT, 0, 10);
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    items.show();
  }

  @Override
  public void refresh(ControllerState state) {
    String wanted = items.chosen().map(ModbusSetup::name).orElse("");
    List<ModbusSignalState> found =
        state.modbus().stream().filter(each -> each.name().equals(wanted)).toList();
    say(value, found.isEmpty() || !found.getFirst().valid() ? "-" : words(found.getFirst()));
    say(status, found.isEmpty() ? text("notAtTheControllerYet") : state(found.getFirst()));
  }

  private static String words(ModbusSignalState signal) {
    return String.join(", ", signal.values().stream().map(String::valueOf).toList());
  }

  private static String state(ModbusSignalState signal) {
    if (signal.connectionError() != 0) {
      return text("noConnection", signal.connectionError());
    }
    if (signal.deviceError() != 0) {
      return text("theDeviceRefusesIt", signal.deviceError());
    }
    return signal.valid() ? text("connected") : text("waitingForTheDevice");
  }

  private static String capital(String words) {
    return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
  }

  private static void say(JLabel label, String text) {
    if (!label.getText().equals(text)) {
      label.setText(text);
    }
  }
}
