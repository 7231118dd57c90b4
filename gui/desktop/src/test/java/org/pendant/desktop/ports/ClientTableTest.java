package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.InetSocketAddress;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.trace.Peers;

final class ClientTableTest {
  private static String waitingTip(String waiting) {
    ClientTable table = new ClientTable();
    Peers peers =
        new Peers(
            "Realtime",
            new InetSocketAddress("127.0.0.1", 30_003),
            new InetSocketAddress("127.0.0.1", 49_468));
    table.show(List.of(new ClientRow(peers, "10 s", "", "", "", waiting, List.of(), List.of())));
    return table.tip(0, 7);
  }

  @Test
  void theTipOfWhatWaitsSaysItWholeWhereTheColumnIsNarrow() {
    assertEquals(
        "1.0 MB, 66 left out: what it has not read yet, and packages that were left out for that",
        waitingTip("1.0 MB, 66 left out"));
    assertEquals(
        "Nothing: what it has not read yet, and packages that were left out for that",
        waitingTip(""));
  }
}
