package org.pendant.protocols.modbusclient;

import static org.pendant.protocols.modbusclient.ModbusClientTexts.text;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.ProtocolException;
import java.nio.ByteBuffer;
import java.util.Arrays;

/** Response framing: cuts the answers out of what a device sends. */
final class ResponseFrame {
  /** Transaction (2 bytes), protocol (2), length of the rest (2); the unit counts to the rest. */
  static final int PREFIX = 6;

  /** Where the function code is. */
  static final int FUNCTION = PREFIX + 1;

  /** Unit, function and one more byte, as in a refusal. */
  static final int MIN_REST = 3;

  /** Unit and the longest answer, 253 bytes. */
  static final int MAX_REST = 254;

  private ResponseFrame() {}

  /**
   * Waits for an answer.
   *
   * @return the answer with its prefix
   * @throws EOFException when the device has closed the connection
   * @throws ProtocolException if this is no Modbus
   */
  static byte[] read(InputStream bytes) throws IOException {
    DataInputStream in = new DataInputStream(bytes);
    byte[] prefix = new byte[PREFIX];
    in.readFully(prefix);
    ByteBuffer head = ByteBuffer.wrap(prefix);
    int protocol = head.getShort(2) & 0xFFFF;
    int rest = head.getShort(4) & 0xFFFF;
    if (protocol != 0 || rest < MIN_REST || rest > MAX_REST) {
      throw new ProtocolException(text("wrongFrame", protocol, rest));
    }
    byte[] frame = Arrays.copyOf(prefix, PREFIX + rest);
    in.readFully(frame, PREFIX, rest);
    return frame;
  }

  /** The number of the question that a frame answers. */
  static int transaction(byte[] frame) {
    return ByteBuffer.wrap(frame).getShort(0) & 0xFFFF;
  }
}
