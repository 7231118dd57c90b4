package org.pendant.desktop.ports;

import static org.pendant.desktop.ports.PortsTexts.text;

import java.util.List;
import java.util.Locale;
import org.pendant.kit.table.RowsModel;
import org.pendant.protocols.trace.WireMessage;
import org.pendant.protocols.wire.Direction;

/** Message table: messages of clients as rows, the oldest first. */
@SuppressWarnings("serial") // never written to a stream
final class MessageTable extends RowsModel<WireMessage> {
  private static final List<String> TITLES =
      List.of(text("time"), "", text("client"), text("port"), text("type"), text("message"));

  MessageTable() {
    super(TITLES);
  }

  /** The row of the message with this number; -1 if it is not shown. */
  int rowOf(long number) {
    int from = 0;
    int to = getRowCount();
    while (from < to) {
      int middle = (from + to) / 2;
      if (row(middle).number() < number) {
        from = middle + 1;
      } else {
        to = middle;
      }
    }
    return from < getRowCount() && row(from).number() == number ? from : -1;
  }

  @Override
  protected Object cell(WireMessage shown, int column) {
    return switch (column) {
      case 0 -> String.format(Locale.ROOT, "%.3f s", shown.robotTimeS());
      case 1 -> shown.direction() == Direction.IN ? "\u2192" : "\u2190";
      case 2 -> shown.peers().client();
      case 3 -> shown.peers().port();
      case 4 -> shown.reading().type();
      default -> MessageWords.line(shown.reading());
    };
  }
}
