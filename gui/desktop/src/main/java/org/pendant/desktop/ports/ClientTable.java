package org.pendant.desktop.ports;

import java.util.List;
import org.pendant.kit.table.RowsModel;

/** Client table: the clients of the ports as rows. */
@SuppressWarnings("serial") // never written to a stream
final class ClientTable extends RowsModel<ClientRow> {
  private static final List<String> TITLES =
      List.of("Client", "Port", "For", "In", "Out", "Data", "Owns", "Waiting");

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
      case 6 -> shown.writes().isEmpty() ? "" : shown.writes().size() + " inputs";
      default -> shown.waiting();
    };
  }

  /** What is behind a cell; empty for no more than it shows. */
  String tip(int row, int column) {
    ClientRow shown = row(row);
    return switch (column) {
      case 5 -> names("Gets", shown.reads());
      case 6 -> names("Only it may write", shown.writes());
      case 2 -> "For how long it has been connected";
      case 3 -> shown.in().isEmpty() ? "Nothing comes from it" : shown.in() + " come from it";
      case 4 -> shown.out().isEmpty() ? "Nothing goes to it" : shown.out() + " go to it";
      case 7 ->
          (shown.waiting().isEmpty() ? "Nothing" : shown.waiting())
              + ": what it has not read yet, and packages that were left out for that";
      default -> getValueAt(row, column).toString();
    };
  }

  private static String names(String what, List<String> names) {
    return names.isEmpty() ? "" : "<html><body width=360>" + what + ": " + String.join(", ", names);
  }
}
