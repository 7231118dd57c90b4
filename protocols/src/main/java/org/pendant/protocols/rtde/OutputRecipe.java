package org.pendant.protocols.rtde;

import java.nio.ByteOrder;
import java.util.List;
import org.pendant.controller.quantity.ScalarType;
import org.pendant.controller.rtde.OutputField;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.packet.PacketLayout;
import org.pendant.protocols.packet.WireType;

/**
 * Output recipe: which fields a client gets, and how they are sent. Only one thread at a time uses
 * an object.
 */
final class OutputRecipe {
  /** The only recipe of a connection. */
  static final int ID = 1;

  private final PacketLayout layout;

  /**
   * A recipe of these fields.
   *
   * @param numbered whether data packages carry the recipe's number, as they do since version 2
   */
  OutputRecipe(List<OutputField> fields, boolean numbered) {
    int bytes = packetBytes(fields, numbered);
    PacketLayout.Builder packet = new PacketLayout.Builder(bytes, ByteOrder.BIG_ENDIAN);
    packet.bytes((byte) (bytes >> Byte.SIZE), (byte) bytes, (byte) PacketType.DATA);
    if (numbered) {
      packet.bytes((byte) ID);
    }
    for (OutputField field : fields) {
      packet.put(wireType(field.quantity().type()), field.quantity(), field.from(), field.count());
    }
    layout = packet.build();
  }

  private static WireType wireType(ScalarType type) {
    return switch (type) {
      case BOOL, UINT8 -> WireType.INT8;
      case INT32, UINT32 -> WireType.INT32;
      case UINT64 -> WireType.INT64;
      case DOUBLE -> WireType.FLOAT64;
    };
  }

  /** The data package for a snapshot. */
  byte[] encode(ControllerState state) {
    return layout.encode(state);
  }

  /** How long a data package is; more than {@link Packet#MAX_BYTES} cannot be sent. */
  static int packetBytes(List<OutputField> fields, boolean numbered) {
    int bytes = Packet.HEADER_BYTES + (numbered ? 1 : 0);
    for (OutputField field : fields) {
      bytes += field.type().bytes();
    }
    return bytes;
  }
}
