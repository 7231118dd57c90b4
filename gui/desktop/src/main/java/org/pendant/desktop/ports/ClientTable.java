package org.pendant.desktop.ports;

import static org.pendant.desktop.ports.PortsTexts.text;

import java.util.List;
import org.pendant.kit.table.RowsModel;

/** Client table: the clients of the ports as rows. */
@SuppressWarnings("serial") // never written to a stream
final class ClientTable extends RowsModel<ClientRow> {
  private static final List<String> TITLES =
      List.of(
          text("client"),
          text("port"),
          text("for"),
          text("in"),
          text("out"),
          text("data"),
          text("owns"),
          text("waiting"));

  ClientTable() {
    super(TITLES);
  }

  /** Shows other rows; answers whether they are those of other clients. */
  @Override
  public boolean show(List<? extends ClientRow> now) {
    boolean same =
        now.stream()
            .map(ClientRow::peers)
            .toList()
            .equals(rows().stream().map(ClientRow::peers).toList());
    return same ? super.show(now) : replace(now);
  }

  @Override
  protected Object cell(ClientRow shown, int column) {
    return switch (column) {
      case 0 -> shown.peers().client();
      case 1 -> shown.peers().port();
      case 2 -> shown.connected();
      case 3 -> shown.in();
      case 4 -> shown.out();
      case 5 -> shown.data();
      case 6 -> shown.writes().isEmpty() ? "" : text("inputCount", shown.writes().size());
      default -> shown.waiting();
    };
  }

  /** What is behind a cell; empty for no more than it shows. */
  String tip(int row, int column) {
    ClientRow shown = row(row);
    return switch (column) {
      case 5 -> names("gets", shown.reads());
      case 6 -> names("onlyItMayWrite", shown.writes());
      case 2 -> text("forHowLong");
      case 3 -> shown.in().isEmpty() ? text("nothingComes") : text("comeFromIt", shown.in());
      case 4 -> shown.out().isEmpty() ? text("nothingGoes") : text("goToIt", shown.out());
      case 7 -> shown.waiting().isEmpty() ? text("nothingWaits") : text("waits", shown.waiting());
      default -> getValueAt(row, column).toString();
    };
  }

  private static String names(String key, List<String> names) {
    return names.isEmpty() ? "" : "<html><body width=360>" + text(key, String.join(", ", names));
  }
}
