package org.pendant.protocols.eip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DiscoveryTest {
  private static final long SECOND_NS = TimeUnit.SECONDS.toNanos(1);

  private final Discovery discovery =
      new Discovery(
          EipServer.STANDARD_PORT,
          () ->
              Encapsulation.identity(
                  new InetSocketAddress(InetAddress.getLoopbackAddress(), EipServer.STANDARD_PORT),
                  0));

  private static ByteBuffer bytes(int command, int status, int options, String data) {
    return ByteBuffer.wrap(
            new EncapsulationFrame(command, 0, status, 5, options, Hex.buffer(data)).encode())
        .order(ByteOrder.LITTLE_ENDIAN);
  }

  private static InetSocketAddress peer(int number) throws UnknownHostException {
    byte[] address = {10, 0, (byte) (number >> 8), (byte) number};
    return new InetSocketAddress(InetAddress.getByAddress(address), 50_000 + number);
  }

  private boolean answers(InetSocketAddress from, long nowNs) {
    return discovery.answer(bytes(Encapsulation.LIST_IDENTITY, 0, 0, ""), from, nowNs).isPresent();
  }

  @ParameterizedTest
  @ValueSource(
      ints = {
        Encapsulation.LIST_SERVICES,
        Encapsulation.LIST_IDENTITY,
        Encapsulation.LIST_INTERFACES
      })
  void questionsAreAnsweredAndAnswersAreNot(int command) throws UnknownHostException {
    Optional<byte[]> answer = discovery.answer(bytes(command, 0, 0, ""), peer(1), 0);
    assertTrue(answer.isPresent());
    ByteBuffer back = ByteBuffer.wrap(answer.get()).order(ByteOrder.LITTLE_ENDIAN);
    assertEquals(Optional.empty(), discovery.answer(back, peer(1), 0));
  }

  @Test
  void onlyRequestsThatNeedNoSessionAreAnswered() throws UnknownHostException {
    InetSocketAddress from = peer(1);
    for (ByteBuffer none :
        new ByteBuffer[] {
          bytes(Encapsulation.LIST_IDENTITY, 1, 0, ""),
          bytes(Encapsulation.LIST_IDENTITY, 0, 1, ""),
          bytes(Encapsulation.LIST_IDENTITY, 0, 0, "00"),
          bytes(Encapsulation.LIST_IDENTITY, 0, 0, "").limit(23),
          bytes(Encapsulation.NOP, 0, 0, ""),
          bytes(Encapsulation.REGISTER_SESSION, 0, 0, ""),
          bytes(Encapsulation.SEND_RR_DATA, 0, 0, ""),
          ByteBuffer.allocate(0).order(ByteOrder.LITTLE_ENDIAN)
        }) {
      assertEquals(Optional.empty(), discovery.answer(none, from, 0));
    }
  }

  @Test
  void whatItSeemsToHaveSentItselfIsNotAnswered() {
    InetAddress here = InetAddress.getLoopbackAddress();
    assertFalse(answers(new InetSocketAddress(here, EipServer.STANDARD_PORT), 0));
    assertTrue(answers(new InetSocketAddress(here, EipServer.STANDARD_PORT + 1), 0));
  }

  @Test
  void oneAddressGetsTenAnswersInASecond() throws UnknownHostException {
    int count = 0;
    for (int port = 1; port <= 1000; port++) {
      if (answers(new InetSocketAddress(peer(1).getAddress(), port), port)) {
        count++;
      }
    }
    assertEquals(10, count);
    assertTrue(answers(peer(2), 1000), "others are answered");
    assertFalse(answers(peer(1), SECOND_NS), "the second is not over");
    assertTrue(answers(peer(1), SECOND_NS + 1));
  }

  @Test
  void allAddressesTogetherGetTwoHundredAnswersInASecond() throws UnknownHostException {
    int count = 0;
    for (int number = 0; number < 5000; number++) {
      if (answers(peer(number), 0)) {
        count++;
      }
    }
    assertEquals(200, count);
    assertTrue(answers(peer(7), SECOND_NS));
  }
}
