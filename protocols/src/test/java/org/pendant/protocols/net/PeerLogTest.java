package org.pendant.protocols.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.LogEntry.Level;

class PeerLogTest {
  private static final long SECOND_NS = 1_000_000_000L;

  private final List<String> written = new ArrayList<>();
  private long nowNs;
  private final PeerLog log =
      new PeerLog((level, text) -> written.add(text), Optional.empty(), () -> nowNs);

  @Test
  void leavesOutAndCountsWhatIsMoreThanTenLinesASecond() {
    for (int i = 0; i < 25; i++) {
      log.write(Level.WARNING, "line " + i);
    }
    assertEquals(PeerLog.PER_SECOND, written.size());
    nowNs += SECOND_NS;
    log.write(Level.INFO, "next");
    assertEquals("15 more messages about connections were left out", written.get(10));
    assertEquals("next", written.get(11));
  }
}
