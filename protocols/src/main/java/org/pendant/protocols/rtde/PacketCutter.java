package org.pendant.protocols.rtde;

import static org.pendant.protocols.rtde.RtdeTexts.text;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;
import org.pendant.protocols.net.ProtocolException;

/**
 * Packet framing: puts packages together from bytes that come cut anywhere. Memory follows the
 * longest package that has come, at most 64 KiB.
 */
final class PacketCutter {
  private byte[] begun = new byte[256];
  private int filled;

  /**
   * Takes bytes until a package is whole.
   *
   * @return empty when more bytes are needed
   * @throws ProtocolException if a size says that this is no RTDE
   */
  Optional<Packet> next(ByteBuffer bytes) throws ProtocolException {
    if (!take(bytes, Packet.HEADER_BYTES)) {
      return Optional.empty();
    }
    int size = Byte.toUnsignedInt(begun[0]) << 8 | Byte.toUnsignedInt(begun[1]);
    if (size < Packet.HEADER_BYTES) {
      throw new ProtocolException(text("packageTooShort", size, Packet.HEADER_BYTES));
    }
    if (!take(bytes, size)) {
      return Optional.empty();
    }
    filled = 0;
    byte[] payload = Arrays.copyOfRange(begun, Packet.HEADER_BYTES, size);
    return Optional.of(new Packet(Byte.toUnsignedInt(begun[2]), ByteBuffer.wrap(payload)));
  }

  /** Fills up to {@code end} bytes; answers whether there were enough. */
  private boolean take(ByteBuffer bytes, int end) {
    if (begun.length < end) {
      begun = Arrays.copyOf(begun, end);
    }
    int count = Math.min(end - filled, bytes.remaining());
    if (count > 0) {
      bytes.get(begun, filled, count);
      filled += count;
    }
    return filled >= end;
  }
}
