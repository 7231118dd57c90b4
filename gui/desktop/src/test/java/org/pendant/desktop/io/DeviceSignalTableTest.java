package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.wire.SignalGroupState;

final class DeviceSignalTableTest {
  private final List<String> set = new ArrayList<>();
  private final DeviceSignals signals =
      new DeviceSignals((name, value) -> set.add(name + " = " + value), set::add);
  private final DeviceSignalTable table = new DeviceSignalTable("signals", signals);

  private DeviceSignalTableTest() {
    signals.show(
        new DeviceState(
            "plc",
            "PLC",
            0,
            0,
            0,
            true,
            0,
            0,
            0,
            0,
            List.of(
                new SignalGroupState("coil", 0, true, true, List.of(0)),
                new SignalGroupState("register", 0, false, true, List.of(5)))));
  }

  @Test
  void whatIsTypedTakesThePlaceOfTheNumber() {
    assertTrue(table.editCellAt(1, DeviceSignals.VALUE, null));
    JTextComponent field = (JTextComponent) table.getEditorComponent();
    field.replaceSelection("42");
    table.getCellEditor().stopCellEditing();
    assertEquals(List.of("plc.register[0] = 42"), set);
  }

  @Test
  void keysChangeTheValueOfTheRowThatWasClickedAtItsName() {
    table.changeSelection(1, DeviceSignals.NAME, false, false);
    assertEquals(DeviceSignals.VALUE, table.getSelectedColumn());
    assertTrue(table.isCellSelected(1, DeviceSignals.NAME), "all of the row is marked");
  }
}
