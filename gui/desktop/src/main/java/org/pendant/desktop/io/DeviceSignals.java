package org.pendant.desktop.io;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.table.AbstractTableModel;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.wire.SignalGroupState;

/** Device signals: what others in the cell are wired to at a device, a row for each signal. */
@SuppressWarnings("serial") // never written to a stream
final class DeviceSignals extends AbstractTableModel {
  static final int NAME = 0;
  static final int VALUE = 1;

  /** The signal that has a box of its own: whether the device is on the network. */
  static final String ONLINE = "online";

  private static final List<String> TITLES = List.of("Signal", "Value");

  private final transient BiConsumer<String, Integer> set;
  private final transient Consumer<String> refuse;
  private String device = "";
  private List<Row> rows = List.of();

  /** A signal. */
  private record Row(String name, int value, boolean digital, boolean settable) {}

  /**
   * A table without rows.
   *
   * @param set sets a signal, such as {@code plc.coil[0]}
   * @param refuse tells why what was typed is no value
   */
  DeviceSignals(BiConsumer<String, Integer> set, Consumer<String> refuse) {
    this.set = set;
    this.refuse = refuse;
  }

  /** Whether a device is on the network; empty signals where that cannot be said. */
  static List<SignalGroupState> online(DeviceState state) {
    return state.signals().stream().filter(each -> each.name().equals(ONLINE)).toList();
  }

  /** Shows what a device has now. */
  void show(DeviceState state) {
    List<Row> now = new ArrayList<>();
    for (SignalGroupState group : state.signals()) {
      for (int i = 0; i < group.values().size() && !group.name().equals(ONLINE); i++) {
        now.add(
            new Row(
                group.name() + "[" + (group.first() + i) + "]",
                group.values().get(i),
                group.digital(),
                group.settable()));
      }
    }
    List<Row> before = rows;
    device = state.name();
    rows = now;
    if (before.size() != now.size()) {
      fireTableDataChanged();
      return;
    }
    for (int i = 0; i < now.size(); i++) {
      if (!now.get(i).equals(before.get(i))) {
        fireTableRowsUpdated(i, i);
      }
    }
  }

  /** Whether a row is a level, which a click changes. */
  boolean digital(int row) {
    return rows.get(row).digital();
  }

  /** Whether a row's signal can be set. */
  boolean settable(int row) {
    return rows.get(row).settable();
  }

  /** Whether a row's signal is on. */
  boolean high(int row) {
    return rows.get(row).value() != 0;
  }

  /** Changes a level. */
  void toggle(int row) {
    if (row >= 0 && row < rows.size() && digital(row) && settable(row)) {
      set.accept(device + "." + rows.get(row).name(), high(row) ? 0 : 1);
    }
  }

  @Override
  public int getRowCount() {
    return rows.size();
  }

  @Override
  public int getColumnCount() {
    return TITLES.size();
  }

  @Override
  public String getColumnName(int column) {
    return TITLES.get(column);
  }

  @Override
  public Object getValueAt(int row, int column) {
    return column == NAME ? rows.get(row).name() : Integer.toString(rows.get(row).value());
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column == VALUE && settable(row) && !digital(row);
  }

  @Override
  public void setValueAt(Object typed, int row, int column) {
    String text = typed.toString().strip();
    try {
      set.accept(device + "." + rows.get(row).name(), Integer.parseInt(text));
    } catch (NumberFormatException _) {
      refuse.accept(rows.get(row).name() + " is \"" + text + "\", must be a whole number");
    }
  }
}
