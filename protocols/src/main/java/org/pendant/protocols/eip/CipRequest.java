package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * CIP request to an object (CIP volume 1, 2-4).
 *
 * @param service what to do
 * @param path the bytes of the path to the object
 * @param data what the service needs, little-endian
 */
record CipRequest(int service, ByteBuffer path, ByteBuffer data) {
  static final int GET_ALL = 0x01;
  static final int GET_ATTRIBUTE = 0x0E;
  static final int SET_ATTRIBUTE = 0x10;
  static final int FORWARD_CLOSE = 0x4E;
  static final int UNCONNECTED_SEND = 0x52;
  static final int FORWARD_OPEN = 0x54;
  static final int LARGE_FORWARD_OPEN = 0x5B;

  /** The bit that answers have in their service. */
  static final int ANSWER = 0x80;

  /**
   * Takes a request apart.
   *
   * @throws CipRefusal if it is too short for its path
   */
  static CipRequest decode(ByteBuffer bytes) throws CipRefusal {
    ByteBuffer in = bytes.slice().order(ByteOrder.LITTLE_ENDIAN);
    if (in.remaining() < 2) {
      throw new CipRefusal(CipRefusal.TOO_SHORT);
    }
    int service = Byte.toUnsignedInt(in.get());
    int length = 2 * Byte.toUnsignedInt(in.get());
    if (in.remaining() < length) {
      throw new CipRefusal(CipRefusal.PATH_SEGMENT);
    }
    ByteBuffer path = in.slice(in.position(), length).order(ByteOrder.LITTLE_ENDIAN);
    in.position(in.position() + length);
    return new CipRequest(service, path, in.slice().order(ByteOrder.LITTLE_ENDIAN));
  }

  /** The answer of success. */
  ByteBuffer answer(ByteBuffer result) {
    return new LittleEndian().u8(service | ANSWER).u8(0).u8(0).u8(0).bytes(result).toBuffer();
  }

  /** The answer that refuses. */
  ByteBuffer answer(CipRefusal refusal, ByteBuffer result) {
    return refused(service, refusal, result);
  }

  /** The answer that refuses a request, or what there is of one. */
  static ByteBuffer refused(int service, CipRefusal refusal, ByteBuffer result) {
    LittleEndian out = new LittleEndian().u8(service | ANSWER).u8(0).u8(refusal.status());
    out.u8(refusal.extended().size());
    refusal.extended().forEach(out::u16);
    return out.bytes(result).toBuffer();
  }
}
