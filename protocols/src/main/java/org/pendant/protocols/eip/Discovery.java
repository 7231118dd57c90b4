package org.pendant.protocols.eip;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/**
 * Discovery: answers datagrams of clients that only ask which devices there are; sessions are for
 * TCP.
 *
 * <p>Any sender can write a foreign address on a datagram, and answers are longer than questions.
 * So an answer never begets another one: questions carry no data, answers always do. And there are
 * few of them for one address, and for all. Used by one thread.
 */
final class Discovery {
  /** Most answers to one address in a second; who looks for devices asks once in some seconds. */
  static final int MAX_PER_SOURCE = 10;

  /** Most answers in a second, and most addresses that are remembered. */
  static final int MOST = 200;

  private static final long WINDOW_NS = TimeUnit.SECONDS.toNanos(1);

  private final int ownPort;
  private final Supplier<ByteBuffer> identity;
  private final Map<InetAddress, Integer> answered = new HashMap<>();
  private int answeredInAll;
  private long windowNs;

  /**
   * Answers for the adapter at a port.
   *
   * @param identity what ListIdentity tells
   */
  Discovery(int ownPort, Supplier<ByteBuffer> identity) {
    this.ownPort = ownPort;
    this.identity = identity;
  }

  /**
   * What to send back, if it is anything.
   *
   * @param bytes the datagram, little-endian, from position to limit
   * @param nowNs of the clock that {@link System#nanoTime} reads
   */
  Optional<byte[]> answer(ByteBuffer bytes, InetSocketAddress from, long nowNs) {
    // The length of the data is a request's, 0, and that of the datagram agrees.
    if (bytes.remaining() != EncapsulationFrame.HEADER || bytes.getShort(2) != 0) {
      return Optional.empty();
    }
    EncapsulationFrame frame = EncapsulationFrame.decode(bytes);
    Optional<ByteBuffer> answer =
        switch (frame.command()) {
          case Encapsulation.LIST_SERVICES -> Optional.of(Encapsulation.services());
          case Encapsulation.LIST_IDENTITY -> Optional.of(identity.get());
          case Encapsulation.LIST_INTERFACES -> Optional.of(Encapsulation.items());
          default -> Optional.empty();
        };
    return frame.isRequest() && answer.isPresent() && !fromHere(from) && allowed(from, nowNs)
        ? answer.map(data -> frame.answer(Encapsulation.SUCCESS, data).encode())
        : Optional.empty();
  }

  private boolean fromHere(InetSocketAddress from) {
    try {
      return from.getPort() == ownPort
          && NetworkInterface.getByInetAddress(from.getAddress()) != null;
    } catch (SocketException e) {
      return true;
    }
  }

  private boolean allowed(InetSocketAddress from, long nowNs) {
    if (answeredInAll == 0 || nowNs - windowNs >= WINDOW_NS) {
      windowNs = nowNs;
      answeredInAll = 0;
      answered.clear();
    }
    if (answeredInAll == MOST || answered.getOrDefault(from.getAddress(), 0) == MAX_PER_SOURCE) {
      return false;
    }
    answeredInAll++;
    answered.merge(from.getAddress(), 1, Integer::sum);
    return true;
  }
}
