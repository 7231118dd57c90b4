package org.pendant.protocols.eip;

import static org.pendant.protocols.eip.EipTexts.text;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * Cyclic connection: cyclic data in both directions. A thread that uses it holds the lock of the
 * connections.
 */
final class CyclicConnection {
  /** A scanner has this long for its first packet, if its own time is not longer. */
  private static final long FIRST_NS = TimeUnit.SECONDS.toNanos(10);

  /** The 32 bits in front of an assembly from the scanner. */
  private static final int RUN_IDLE_BYTES = 4;

  private final int id;
  private final OpenRequest request;
  private final InetSocketAddress scanner;
  private final int fromScanner;
  private final int toScanner;
  private Optional<Runnable> endProduction = Optional.empty();
  private boolean heard;
  private boolean running;
  private int heardNumber;
  private long heardNs;
  private int sentNumber;

  /**
   * A connection that has just been opened.
   *
   * @param id number of packets to the box
   * @param scanner where packets go to
   * @param fromScanner instance that the scanner writes
   * @param toScanner instance that the robot writes
   */
  CyclicConnection(
      int id,
      OpenRequest request,
      InetSocketAddress scanner,
      int fromScanner,
      int toScanner,
      long nowNs) {
    this.id = id;
    this.request = request;
    this.scanner = scanner;
    this.fromScanner = fromScanner;
    this.toScanner = toScanner;
    heardNs = nowNs;
  }

  int id() {
    return id;
  }

  OpenRequest request() {
    return request;
  }

  InetSocketAddress scanner() {
    return scanner;
  }

  int fromScanner() {
    return fromScanner;
  }

  int toScanner() {
    return toScanner;
  }

  /** Under which name it has taken what it writes. */
  String owner() {
    return text("scanner", scanner.getAddress().getHostAddress(), id);
  }

  /** Whether the scanner says that it runs. */
  boolean running() {
    return running;
  }

  void endProductionBy(Runnable end) {
    endProduction = Optional.of(end);
  }

  void endProduction() {
    endProduction.ifPresent(Runnable::run);
  }

  boolean late(long nowNs) {
    long allowedNs = request.timeoutNs();
    return nowNs - heardNs > (heard ? allowedNs : Math.max(allowedNs, FIRST_NS));
  }

  /**
   * A packet of the scanner has come.
   *
   * @return the assembly in it, when the scanner runs; also one that has not changed, which shows
   *     that the scanner continues
   */
  Optional<ByteBuffer> take(IoPacket packet, long nowNs) {
    ByteBuffer data = packet.data();
    if (data.remaining() != request.toTarget().bytes() - 2
        || (heard && packet.number() - heardNumber <= 0)) {
      return Optional.empty();
    }
    heard = true;
    heardNs = nowNs;
    heardNumber = packet.number();
    running = (data.getInt(0) & 1) != 0;
    return running
        ? Optional.of(data.slice(RUN_IDLE_BYTES, data.remaining() - RUN_IDLE_BYTES))
        : Optional.empty();
  }

  /** The next packet to the scanner. */
  byte[] next(ByteBuffer data) {
    sentNumber++;
    return new IoPacket(request.toOriginatorId(), sentNumber, sentNumber & 0xFFFF, data).encode();
  }
}
