package org.pendant.protocols.modbusclient;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.external.ModbusReading;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.egress.HostPolicy;

class PointTest {
  private static final long MS = 1_000_000;

  private final ModbusAddress address = new ModbusAddress("d", 502);
  private final Device device = new Device(address, new HostPolicy(AllowedHosts.ANY), gone -> {});
  private final Point point =
      new Point(
          new ModbusExchange(address, 1, ModbusKind.REGISTER_OUTPUT, 0, 1, 0, 1, false), device);

  private void exchange(long nowNs) {
    var _ = point.ask(nowNs);
    point.answered(new DeviceResponse.Values(List.of(7)));
  }

  /** How often it is asked within so many ms, when each turn comes late by {@code lateMs}. */
  private int asked(int forMs, int lateMs) {
    int count = 0;
    for (long nowMs = 0; nowMs < forMs; nowMs++) {
      if (point.dueInNs((nowMs - lateMs) * MS) <= 0) {
        exchange(nowMs * MS);
        count++;
      }
    }
    return count;
  }

  @Test
  void isAskedTenTimesASecondUnlessSaid() {
    assertEquals(100, asked(10_000, 0));
  }

  @Test
  void keepsItsFrequencyWhenEachTurnComesLate() {
    point.setFrequency(20);
    assertEquals(200, asked(10_000, 7), 1);
  }

  @Test
  void doesNotCatchUpWithWhatIsLongPast() {
    exchange(0);
    exchange(950 * MS);
    assertEquals(100 * MS, point.dueInNs(950 * MS));
  }

  @Test
  void aHigherFrequencyCountsAtOnce() {
    point.setFrequency(1);
    exchange(0);
    assertEquals(1000 * MS, point.dueInNs(0));
    point.setFrequency(100);
    assertEquals(10 * MS, point.dueInNs(0));
  }

  @Test
  void isNotAskedAgainBeforeItHasItsAnswer() {
    var _ = point.ask(0);
    point.update();
    assertEquals(Asker.NEVER, point.dueInNs(500 * MS));
    point.answered(new DeviceResponse.Values(List.of(1)));
    assertTrue(point.dueInNs(1 * MS) <= 0);
  }

  @Test
  void onDemandItIsAskedForEachWishOnly() {
    point.setFrequency(0);
    exchange(0);
    assertEquals(Asker.NEVER, point.dueInNs(1 * MS));
    point.update();
    assertEquals(0, point.dueInNs(1 * MS));
    exchange(1 * MS);
    point.write(List.of(3));
    assertEquals(0, point.dueInNs(2 * MS));
    exchange(2 * MS);
    assertEquals(Asker.NEVER, point.dueInNs(3 * MS));
  }

  @Test
  void whatWasLostWithTheConnectionIsAskedAgain() {
    point.setFrequency(0);
    var _ = point.ask(0);
    point.dropped();
    assertEquals(0, point.dueInNs(1 * MS));
  }

  @Test
  void tellsTheNewestValuesAndWhatIsWrong() {
    assertEquals(new ModbusReading(List.of(0), 0, ModbusErrors.DISCONNECTED), point.reading());
    exchange(0);
    assertEquals(new ModbusReading(List.of(7), 0, 0), point.reading());
    assertEquals(1, point.successes());
    var _ = point.ask(100 * MS);
    point.answered(new DeviceResponse.Refused(4));
    assertEquals(new ModbusReading(List.of(7), 4, 0), point.reading());
    point.disconnected(ModbusErrors.RESET);
    assertEquals(new ModbusReading(List.of(7), 4, ModbusErrors.RESET), point.reading());
    assertEquals(1, point.successes());
  }
}
