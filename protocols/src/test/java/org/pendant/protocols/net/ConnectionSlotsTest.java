package org.pendant.protocols.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.net.ConnectionSlots.Admission;
import org.pendant.protocols.net.Silence.Kind;

class ConnectionSlotsTest {
  private static final InetAddress HERE = InetAddress.getLoopbackAddress();
  private static final int MOST = 32;

  private final ConnectionSlots<Peer> slots = new ConnectionSlots<>(MOST);

  private record Peer(String name, InetAddress address, Kind kind, long sinceS)
      implements Occupant {
    @Override
    public Silence silence(long nowNs) {
      return new Silence(kind, nowNs - TimeUnit.SECONDS.toNanos(sinceS));
    }
  }

  private static InetAddress host(int number) {
    try {
      return InetAddress.getByAddress(new byte[] {10, 0, 0, (byte) number});
    } catch (UnknownHostException e) {
      throw new AssertionError(e);
    }
  }

  private Admission<Peer> admit(Peer peer) {
    return slots.admit(peer, TimeUnit.SECONDS.toNanos(100));
  }

  private void fill(int count, InetAddress address, Kind kind, int sinceS) {
    for (int i = 0; i < count; i++) {
      Admission<Peer> admission = admit(new Peer(kind + " " + i, address, kind, sinceS + i));
      assertEquals(new Admission<>(true, Optional.empty()), admission);
    }
  }

  private static Peer newcomer(InetAddress address) {
    return new Peer("newcomer", address, Kind.NEVER_SPOKEN, 100);
  }

  private String givenUpFor(Peer newcomer) {
    return admit(newcomer).givenUp().map(Peer::name).orElse("nobody");
  }

  @Test
  void theLongestSilentPeerMakesRoom() {
    fill(MOST, HERE, Kind.NEVER_SPOKEN, 50);
    assertEquals("NEVER_SPOKEN 0", givenUpFor(newcomer(HERE)));
    assertEquals("NEVER_SPOKEN 1", givenUpFor(new Peer("other", HERE, Kind.NEVER_SPOKEN, 100)));
    assertEquals(MOST, slots.occupants().size());
  }

  @Test
  void whoDoesNotReadGoesBeforeWhoHasNeverSpoken() {
    fill(MOST - 1, HERE, Kind.NEVER_SPOKEN, 10);
    fill(1, HERE, Kind.NOT_READING, 90);
    assertEquals("NOT_READING 0", givenUpFor(newcomer(HERE)));
  }

  @Test
  void whoHasSpokenGoesOnlyAfterAMinuteAndAfterThoseWhoNeverHave() {
    fill(MOST - 1, HERE, Kind.SPOKEN, 39);
    fill(1, HERE, Kind.NEVER_SPOKEN, 99);
    assertEquals("NEVER_SPOKEN 0", givenUpFor(new Peer("one", HERE, Kind.SPOKEN, 100)));
    assertEquals("SPOKEN 0", givenUpFor(new Peer("two", HERE, Kind.SPOKEN, 100)));
    assertEquals(
        new Admission<>(false, Optional.empty()), admit(new Peer("three", HERE, Kind.SPOKEN, 100)));
  }

  @Test
  void theAddressThatHoldsMostPlacesLosesThem() {
    fill(1, host(1), Kind.NEVER_SPOKEN, 1);
    fill(MOST - MOST / 16 - 1, host(2), Kind.NEVER_SPOKEN, 50);
    assertEquals("NEVER_SPOKEN 0", givenUpFor(newcomer(host(3))));
    assertEquals(1, slots.occupants().stream().filter(each -> each.sinceS() == 1).count());
  }

  @Test
  void somePlacesAreForThisComputerOnly() {
    fill(MOST - MOST / 16, host(1), Kind.SPOKEN, 90);
    assertEquals(
        new Admission<>(false, Optional.empty()),
        admit(new Peer("remote", host(2), Kind.SPOKEN, 100)));
    assertEquals(
        new Admission<>(true, Optional.empty()), admit(new Peer("local", HERE, Kind.SPOKEN, 100)));
  }

  @Test
  void remotePeersDoNotTakeThePlacesOfThisComputer() {
    fill(MOST / 16, HERE, Kind.NEVER_SPOKEN, 1);
    fill(MOST - MOST / 16, host(1), Kind.NEVER_SPOKEN, 50);
    assertEquals("NEVER_SPOKEN 0", givenUpFor(newcomer(host(2))));
    assertEquals(MOST / 16, slots.occupants().stream().filter(e -> e.sinceS() < 50).count());
  }

  @Test
  void aPlaceThatIsFreeAgainIsGivenAgain() {
    fill(MOST, HERE, Kind.SPOKEN, 90);
    slots.free(slots.occupants().getFirst());
    assertEquals(new Admission<>(true, Optional.empty()), admit(newcomer(HERE)));
  }
}
