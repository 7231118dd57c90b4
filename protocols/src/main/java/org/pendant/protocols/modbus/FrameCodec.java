package org.pendant.protocols.modbus;

import com.ghgande.j2mod.modbus.msg.ModbusRequest;
import com.ghgande.j2mod.modbus.msg.ModbusResponse;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;

/** Frame codec: frames as j2mod's messages and back. */
final class FrameCodec {
  private FrameCodec() {}

  /** Decodes a frame that has passed {@link RequestCheck}. */
  static ModbusRequest decode(byte[] frame) {
    ModbusRequest request = ModbusRequest.createModbusRequest(RequestCheck.function(frame));
    try {
      request.readFrom(new DataInputStream(new ByteArrayInputStream(frame)));
    } catch (IOException e) {
      // an array has no other fault than its end, and the length is checked
      throw new UncheckedIOException(e);
    }
    return request;
  }

  /** The frame of an answer; transaction and unit are those of the question. */
  static byte[] encode(ModbusResponse response, byte[] question) {
    response.setTransactionID(ByteBuffer.wrap(question).getShort(0) & 0xFFFF);
    response.setProtocolID(0);
    response.setUnitID(question[ModbusFrameReader.PREFIX] & 0xFF);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream(ModbusFrameReader.PREFIX);
    try {
      response.writeTo(new DataOutputStream(bytes));
    } catch (IOException e) {
      // an array takes everything
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }
}
