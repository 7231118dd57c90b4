package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.kit.table.RowsModel;

/** Device signals: what others in the cell are wired to at a device, a row for each signal. */
@SuppressWarnings("serial") // never written to a stream
final class DeviceSignals extends RowsModel<DeviceSignals.Row> {
  static final int NAME = 0;
  static final int VALUE = 1;

  /** The signal that has a box of its own: whether the device is on the network. */
  static final String ONLINE = "online";

  private static final List<String> TITLES = List.of(text("signalColumn"), text("value"));

  private final transient BiConsumer<String, Integer> set;
  private final transient Consumer<String> refuse;
  private String device = "";

  /** A signal. */
  record Row(String name, int value, boolean digital, boolean settable) {}

  /**
   * A table without rows.
   *
   * @param set sets a signal, such as {@code plc.coil[0]}
   * @param refuse tells why what was typed is no value
   */
  DeviceSignals(BiConsumer<String, Integer> set, Consumer<String> refuse) {
    super(TITLES);
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
    device = state.name();
    show(now);
  }

  /** Whether a row is a level, which a click changes. */
  boolean digital(int row) {
    return row(row).digital();
  }

  /** Whether a row's signal can be set. */
  boolean settable(int row) {
    return row(row).settable();
  }

  /** Whether a row's signal is on. */
  boolean high(int row) {
    return row(row).value() != 0;
  }

  /** Changes a level. */
  void toggle(int row) {
    if (row >= 0 && row < getRowCount() && digital(row) && settable(row)) {
      set.accept(device + "." + row(row).name(), high(row) ? 0 : 1);
    }
  }

  @Override
  protected Object cell(Row row, int column) {
    return column == NAME ? row.name() : Integer.toString(row.value());
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column == VALUE && settable(row) && !digital(row);
  }

  @Override
  public void setValueAt(Object typed, int row, int column) {
    String text = typed.toString().strip();
    try {
      set.accept(device + "." + row(row).name(), Integer.parseInt(text));
    } catch (NumberFormatException _) {
      refuse.accept(text("notWholeNumber", row(row).name(), text));
    }
  }
}
