package org.pendant.protocols.modbus;

import static org.pendant.protocols.modbus.ModbusTexts.text;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.ProtocolException;
import org.pendant.protocols.net.Session;

/** Modbus session: one client, whose requests are answered in their order. */
final class ModbusSession implements Session {
  private static final int PROTOCOL_AT = 2;

  private final Connection connection;
  private final Answers answers;
  private final PeerLog log;
  private final ModbusFrameReader cutter = new ModbusFrameReader();

  ModbusSession(Connection connection, Answers answers, PeerLog log) {
    this.connection = connection;
    this.answers = answers;
    this.log = log;
  }

  @Override
  public void received(ByteBuffer bytes) throws ProtocolException {
    for (Optional<byte[]> frame = cutter.next(bytes);
        frame.isPresent();
        frame = cutter.next(bytes)) {
      answer(frame.get());
    }
  }

  private void answer(byte[] frame) {
    int protocol = ByteBuffer.wrap(frame).getShort(PROTOCOL_AT) & 0xFFFF;
    if (protocol == 0) {
      connection.send(answers.answer(frame));
    } else {
      // the guide for Modbus on TCP has such a frame passed over in silence
      log.write(Level.WARNING, text("passedOverFrame", connection.name(), protocol));
    }
  }
}
