package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Encapsulation frame: one message of the encapsulation layer (CIP volume 2, chapter 2).
 *
 * @param command what is asked; see {@link Encapsulation}
 * @param session number that the adapter gave
 * @param status 0 in requests
 * @param context eight bytes that the answer repeats
 * @param options 0
 * @param data little-endian, from position to limit
 */
record EncapsulationFrame(
    int command, int session, int status, long context, int options, ByteBuffer data) {
  /** Bytes in front of the data. */
  static final int HEADER = 24;

  /** Most bytes of data that are taken: two of the largest assemblies and what goes with them. */
  static final int MAX_DATA = 4096;

  /**
   * Whether an adapter has to look at it: what carries a status is an answer to another request.
   */
  boolean isRequest() {
    return status == 0 && options == 0;
  }

  /** The answer to this one. */
  EncapsulationFrame answer(int answerStatus, ByteBuffer answerData) {
    return new EncapsulationFrame(command, session, answerStatus, context, 0, answerData);
  }

  /** The same for another session. */
  EncapsulationFrame ofSession(int number) {
    return new EncapsulationFrame(command, number, status, context, options, data);
  }

  /** The bytes that are sent. */
  byte[] encode() {
    ByteBuffer bytes =
        ByteBuffer.allocate(HEADER + data.remaining()).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putShort((short) command).putShort((short) data.remaining());
    bytes.putInt(session).putInt(status).putLong(context).putInt(options);
    return bytes.put(data.duplicate()).array();
  }

  /**
   * The frame that a buffer holds.
   *
   * @param bytes a header and all the data that it announces
   */
  static EncapsulationFrame decode(ByteBuffer bytes) {
    ByteBuffer in = bytes.duplicate().order(ByteOrder.LITTLE_ENDIAN);
    int command = Short.toUnsignedInt(in.getShort());
    int length = Short.toUnsignedInt(in.getShort());
    int session = in.getInt();
    int status = in.getInt();
    long context = in.getLong();
    int options = in.getInt();
    byte[] data = new byte[length];
    in.get(data);
    return new EncapsulationFrame(
        command,
        session,
        status,
        context,
        options,
        ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN));
  }
}
