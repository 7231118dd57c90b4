package org.pendant.protocols.eip;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Little-endian message writer: puts a message together; numbers are little-endian unless a method
 * says otherwise.
 */
final class LittleEndian {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  LittleEndian u8(int value) {
    bytes.write(value);
    return this;
  }

  LittleEndian u16(int value) {
    return u8(value).u8(value >>> 8);
  }

  LittleEndian u32(int value) {
    return u16(value).u16(value >>> 16);
  }

  LittleEndian u16BigEndian(int value) {
    return u8(value >>> 8).u8(value);
  }

  LittleEndian bytes(byte... more) {
    bytes.writeBytes(more);
    return this;
  }

  /** What is left in a buffer, which is as it was afterwards. */
  LittleEndian bytes(ByteBuffer more) {
    byte[] copy = new byte[more.remaining()];
    more.duplicate().get(copy);
    return bytes(copy);
  }

  /** A text with its length in one byte. */
  LittleEndian shortText(String text) {
    byte[] latin = text.getBytes(StandardCharsets.ISO_8859_1);
    return u8(latin.length).bytes(latin);
  }

  byte[] toArray() {
    return bytes.toByteArray();
  }

  /** What was put together, to be read. */
  ByteBuffer toBuffer() {
    return ByteBuffer.wrap(toArray()).order(ByteOrder.LITTLE_ENDIAN);
  }
}
