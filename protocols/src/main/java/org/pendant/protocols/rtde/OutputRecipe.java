package org.pendant.protocols.rtde;

import java.nio.ByteBuffer;
import java.util.List;
import org.pendant.controller.rtde.OutputField;
import org.pendant.controller.state.ControllerState;

/**
 * Which fields a client gets, and how they are sent.
 *
 * @param numbered whether data packages carry the recipe's number, as they do since version 2
 */
record OutputRecipe(List<OutputField> fields, boolean numbered) {
  /** The only recipe of a connection. */
  static final int ID = 1;

  OutputRecipe {
    fields = List.copyOf(fields);
  }

  /** The data package for a snapshot. */
  byte[] encode(ControllerState state) {
    byte[] bytes = new byte[packetBytes()];
    ByteBuffer packet = ByteBuffer.wrap(bytes);
    packet.putShort((short) bytes.length).put((byte) PacketType.DATA);
    if (numbered) {
      packet.put((byte) ID);
    }
    for (int i = 0; i < fields.size(); i++) {
      fields.get(i).encoder().put(state, packet);
    }
    return bytes;
  }

  /** How long a data package is; more than {@link Packet#MAX_BYTES} cannot be sent. */
  int packetBytes() {
    int bytes = Packet.HEADER_BYTES + (numbered ? 1 : 0);
    for (int i = 0; i < fields.size(); i++) {
      bytes += fields.get(i).type().bytes();
    }
    return bytes;
  }
}
