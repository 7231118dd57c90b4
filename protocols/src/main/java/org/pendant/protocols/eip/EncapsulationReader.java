package org.pendant.protocols.eip;

import static org.pendant.protocols.eip.EipTexts.text;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import org.pendant.protocols.net.ProtocolException;

/** Encapsulation reader: cuts what one peer sends into encapsulation frames. */
final class EncapsulationReader {
  private static final int LENGTH_AT = 2;
  private static final int LENGTH_KNOWN = 4;

  private final ByteBuffer begun =
      ByteBuffer.allocate(EncapsulationFrame.HEADER + EncapsulationFrame.MAX_DATA)
          .order(ByteOrder.LITTLE_ENDIAN);

  /**
   * Takes bytes, cut anywhere, up to the end of a frame.
   *
   * @return the frame that they complete; empty when all are taken and more are needed
   * @throws ProtocolException if a frame is too long
   */
  Optional<EncapsulationFrame> next(ByteBuffer bytes) throws ProtocolException {
    fill(bytes, LENGTH_KNOWN);
    if (begun.position() < LENGTH_KNOWN) {
      return Optional.empty();
    }
    int length = Short.toUnsignedInt(begun.getShort(LENGTH_AT));
    if (length > EncapsulationFrame.MAX_DATA) {
      throw new ProtocolException(text("wrongLength", length, EncapsulationFrame.MAX_DATA));
    }
    fill(bytes, EncapsulationFrame.HEADER + length);
    if (begun.position() < EncapsulationFrame.HEADER + length) {
      return Optional.empty();
    }
    begun.flip();
    EncapsulationFrame frame = EncapsulationFrame.decode(begun);
    begun.clear();
    return Optional.of(frame);
  }

  private void fill(ByteBuffer bytes, int end) {
    int count = Math.min(bytes.remaining(), end - begun.position());
    if (count > 0) {
      begun.put(bytes.slice(bytes.position(), count));
      bytes.position(bytes.position() + count);
    }
  }
}
