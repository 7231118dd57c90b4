package org.pendant.desktop.ports;

import static org.pendant.desktop.ports.PortsTexts.text;

import java.util.List;
import org.pendant.desktop.ports.PortsPresenter.Row;
import org.pendant.kit.table.RowsModel;

/** Port table: the open ports as rows. */
@SuppressWarnings("serial") // never written to a stream
final class PortTable extends RowsModel<Row> {
  private static final List<String> TITLES =
      List.of(text("port"), text("address"), text("clients"));

  PortTable() {
    super(TITLES);
  }

  /** Who is connected there; empty for no client. */
  String who(int row) {
    return row(row).who();
  }

  @Override
  protected Object cell(Row shown, int column) {
    return switch (column) {
      case 0 -> shown.name();
      case 1 -> shown.address();
      default -> shown.clients() == 0 ? "" : Integer.toString(shown.clients());
    };
  }
}
