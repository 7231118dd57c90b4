package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

final class TrafficTest {
  private static final Traffic BEGIN = new Traffic(0, 0, 0, 0, 0);

  @Test
  void tellsMessagesAndBytesOfASecond() {
    Traffic now = new Traffic(2_000_000_000L, 40, 2_400_000, 4, 1_000);
    assertEquals("2/s, 20 B/s", now.in(BEGIN));
    assertEquals("500/s, 1.2 MB/s", now.out(BEGIN));
  }

  @Test
  void saysNothingWhereNothingGoes() {
    assertEquals("", new Traffic(1_000_000_000L, 0, 0, 0, 0).in(BEGIN));
  }
}
