package org.pendant.protocols.trace;

import java.io.IOException;
import java.nio.ByteBuffer;
import org.pendant.protocols.wire.Direction;

/**
 * TCP stream: one connection as the packets that may have carried it (RFC 9293): its bytes and
 * their order are those of the connection, how they were cut into packets is not known.
 */
final class TcpStream {
  /** Most bytes in a packet, as on an Ethernet. */
  private static final int SEGMENT_BYTES = 1460;

  private static final int FIN = 0x01;
  private static final int SYN = 0x02;
  private static final int PUSH = 0x08;
  private static final int ACK = 0x10;

  private final Peers peers;

  /** The numbers of the next byte of each side; a SYN has number 0. */
  private long clientNext = 1;

  private long portNext = 1;

  TcpStream(Peers peers) {
    this.peers = peers;
  }

  /**
   * The handshake.
   *
   * @param outgoing whether our side has begun it
   */
  void open(PcapWriter writer, long epochUs, boolean outgoing) throws IOException {
    Direction asks = outgoing ? Direction.OUT : Direction.IN;
    Direction answers = outgoing ? Direction.IN : Direction.OUT;
    ByteBuffer none = ByteBuffer.allocate(0);
    writer.write(epochUs, segment(asks, 0, 0, SYN), none);
    writer.write(epochUs, segment(answers, 0, 1, SYN | ACK), none);
    writer.write(epochUs, segment(asks, 1, 1, ACK), none);
  }

  /**
   * Bytes of one side.
   *
   * @param before how many it had sent before
   */
  void write(PcapWriter writer, long epochUs, Direction direction, long before, ByteBuffer bytes)
      throws IOException {
    long next = 1 + before;
    while (bytes.hasRemaining()) {
      int count = Math.min(SEGMENT_BYTES, bytes.remaining());
      ByteBuffer piece = bytes.slice(bytes.position(), count);
      bytes.position(bytes.position() + count);
      long acknowledged = direction == Direction.IN ? portNext : clientNext;
      writer.write(epochUs, segment(direction, next, acknowledged, PUSH | ACK), piece);
      next += count;
    }
    if (direction == Direction.IN) {
      clientNext = next;
    } else {
      portNext = next;
    }
  }

  /** Its end, of both sides. */
  void end(PcapWriter writer, long epochUs) throws IOException {
    ByteBuffer none = ByteBuffer.allocate(0);
    writer.write(epochUs, segment(Direction.IN, clientNext, portNext, FIN | ACK), none);
    writer.write(epochUs, segment(Direction.OUT, portNext, clientNext + 1, FIN | ACK), none);
    writer.write(epochUs, segment(Direction.IN, clientNext + 1, portNext + 1, ACK), none);
  }

  private PcapWriter.Segment segment(
      Direction direction, long number, long acknowledged, int flags) {
    return direction == Direction.IN
        ? new PcapWriter.Segment(
            peers.remote(), peers.local(), (int) number, (int) acknowledged, flags)
        : new PcapWriter.Segment(
            peers.local(), peers.remote(), (int) number, (int) acknowledged, flags);
  }
}
