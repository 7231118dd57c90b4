package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import org.pendant.controller.device.DeviceKind;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.io.DeviceRow;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.RotationChoice;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.Measures;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;

/** Devices card: grippers, doors and sensors of the cell, and a form for the chosen one. */
final class DevicesCard {
  private final SceneDraft draft;
  private final TitledCard card = new TitledCard("devices", text("devices"), "[grow, fill]");
  private final Items<DeviceText> items;
  private final DeviceForm form;

  /** What devices of the controller are at, by their names. */
  private Map<String, String> doing = Map.of();

  /**
   * @param measures in which lengths are shown
   * @param rotation how rotations are shown
   * @param signalName the name of a signal such as {@code digital_in[0]}; empty while it has none
   * @param tcpM where the TCP is in the frame of the scene, m
   */
  DevicesCard(
      SceneDraft draft,
      Measures measures,
      RotationChoice rotation,
      UnaryOperator<String> signalName,
      Supplier<Vector3> tcpM) {
    this.draft = draft;
    items =
        new Items<>(
            "cell-device",
            text("devicesOfTheCell"),
            text("noneGrippersDoorsAndSensorsAnswer"),
            new Drafted(),
            this::words);
    List<Items.Kind<DeviceText>> kinds = new ArrayList<>();
    for (DeviceKind kind : DeviceKind.ALL) {
      kinds.add(
          new Items.Kind<>(
              // in English, whichever language it is shown in
              kind.title().toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-"),
              Messages.shown(kind.title()),
              () -> DeviceForm.fresh(kind, devices(), draft.scene())));
    }
    items.adders(text("add"), kinds);
    form =
        new DeviceForm(
            items.form(),
            measures,
            rotation,
            signalName,
            draft::scene,
            () -> SceneFrame.words(draft),
            this::otherSignals,
            key ->
                items
                    .chosen()
                    .map(each -> DevicePlaces.of(each).moved(key, tcpM.get()))
                    .ifPresent(items::replace));
    card.add(items.component());
  }

  private List<WireSignal> otherSignals() {
    List<CellWiring.Group> groups = new ArrayList<>(CellWiring.ofControllers(draft.controllers()));
    groups.addAll(CellWiring.signals(draft.devices().stream().flatMap(List::stream).toList()));
    return groups.stream().flatMap(each -> each.signals().stream()).toList();
  }

  private String words(DeviceText device) {
    String now = doing.getOrDefault(device.name(), "");
    return device.name()
        + "  ("
        + Messages.shown(device.title())
        + ")"
        + (now.isEmpty() ? "" : "  \u2013 " + now);
  }

  /** Shows what devices are at, with lengths in this unit. */
  void refresh(List<DeviceState> states, DisplayUnit length) {
    Map<String, String> now = new HashMap<>();
    for (DeviceState each : states) {
      now.put(each.name(), DeviceRow.of(each, length).doingInSentence());
    }
    if (!now.equals(doing)) {
      doing = now;
      items.show();
    }
  }

  private List<DeviceText> devices() {
    return Equipment.devices(draft.equipment());
  }

  /** The devices of the draft. */
  private final class Drafted implements Items.Model<DeviceText> {
    @Override
    public List<DeviceText> list() {
      return devices();
    }

    @Override
    public String refusal(List<DeviceText> next) {
      return Equipment.refusal(draft.scene(), Equipment.with(draft.equipment(), next));
    }

    @Override
    public void take(
        List<DeviceText> next, Optional<DeviceText> before, Optional<DeviceText> after) {
      draft.setEquipment(Equipment.with(draft.equipment(), next));
    }
  }

  JComponent component() {
    return card;
  }

  /** The name of the device whose form is shown. */
  Optional<String> chosen() {
    return items.chosen().map(DeviceText::name);
  }

  /** Shows the form of a device. */
  void choose(String name) {
    devices().stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .ifPresent(items::choose);
  }

  /** Shows the draft. */
  void show() {
    form.provide(devices());
    items.show();
  }
}
