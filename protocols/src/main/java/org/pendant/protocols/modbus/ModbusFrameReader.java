package org.pendant.protocols.modbus;

import static org.pendant.protocols.modbus.ModbusTexts.text;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.pendant.protocols.net.ProtocolException;

/** Modbus frame reader: puts requests together from bytes that come cut anywhere. */
final class ModbusFrameReader {
  /** Transaction (2 bytes), protocol (2), length of the rest (2); the unit counts to the rest. */
  static final int PREFIX = 6;

  /** Unit and function. */
  static final int MIN_REST = 2;

  /** Unit and the longest request, 253 bytes. */
  static final int MAX_REST = 254;

  private static final int LENGTH_AT = 4;

  private final ByteBuffer begun = ByteBuffer.allocate(PREFIX + MAX_REST);

  /**
   * Takes bytes until a request is whole.
   *
   * @return the request with its prefix; empty when more bytes are needed
   * @throws ProtocolException if a length says that this is no Modbus
   */
  Optional<byte[]> next(ByteBuffer bytes) throws ProtocolException {
    take(bytes, PREFIX);
    if (begun.position() < PREFIX) {
      return Optional.empty();
    }
    int rest = begun.getShort(LENGTH_AT) & 0xFFFF;
    if (rest < MIN_REST || rest > MAX_REST) {
      throw new ProtocolException(text("wrongLength", rest, MIN_REST, MAX_REST));
    }
    take(bytes, PREFIX + rest);
    if (begun.position() < PREFIX + rest) {
      return Optional.empty();
    }
    byte[] request = new byte[PREFIX + rest];
    begun.flip().get(request).clear();
    return Optional.of(request);
  }

  private void take(ByteBuffer bytes, int end) {
    int count = Math.min(end - begun.position(), bytes.remaining());
    if (count > 0) {
      begun.put(begun.position(), bytes, bytes.position(), count);
      begun.position(begun.position() + count);
      bytes.position(bytes.position() + count);
    }
  }
}
