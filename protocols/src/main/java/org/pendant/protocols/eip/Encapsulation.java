package org.pendant.protocols.eip;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Encapsulation layer: its commands, and answers that need no session. */
final class Encapsulation {
  static final int NOP = 0x0000;
  static final int LIST_SERVICES = 0x0004;
  static final int LIST_IDENTITY = 0x0063;
  static final int LIST_INTERFACES = 0x0064;
  static final int REGISTER_SESSION = 0x0065;
  static final int UNREGISTER_SESSION = 0x0066;
  static final int SEND_RR_DATA = 0x006F;
  static final int SEND_UNIT_DATA = 0x0070;

  static final int SUCCESS = 0x0000;
  static final int UNKNOWN_COMMAND = 0x0001;
  static final int NO_MEMORY = 0x0002;
  static final int BAD_DATA = 0x0003;
  static final int BAD_SESSION = 0x0064;
  static final int BAD_LENGTH = 0x0065;
  static final int BAD_VERSION = 0x0069;

  static final int VERSION = 1;

  private static final int MESSAGES_AND_CYCLIC_DATA = 0x0120;
  private static final int SERVICE_NAME = 16;
  private static final int INTERNET = 2;
  private static final int OPERATIONAL = 3;

  private Encapsulation() {}

  /** No data. */
  static ByteBuffer nothing() {
    return ByteBuffer.allocate(0);
  }

  /** What ListServices tells. */
  static ByteBuffer services() {
    byte[] name = new byte[SERVICE_NAME];
    byte[] text = "Communications".getBytes(StandardCharsets.ISO_8859_1);
    System.arraycopy(text, 0, name, 0, text.length);
    ByteBuffer service =
        new LittleEndian().u16(VERSION).u16(MESSAGES_AND_CYCLIC_DATA).bytes(name).toBuffer();
    return items(new PacketItem(PacketItem.SERVICE, service));
  }

  /**
   * What ListIdentity tells.
   *
   * @param address where the adapter listens
   * @param status as the identity object has it
   */
  static ByteBuffer identity(InetSocketAddress address, int status) {
    DeviceIdentity own = DeviceIdentity.OWN;
    ByteBuffer identity =
        new LittleEndian()
            .u16(VERSION)
            .bytes(socket(address))
            .u16(own.vendor())
            .u16(own.deviceType())
            .u16(own.productCode())
            .u8(own.major())
            .u8(own.minor())
            .u16(status)
            .u32(own.serial())
            .shortText(own.name())
            .u8(OPERATIONAL)
            .toBuffer();
    return items(new PacketItem(PacketItem.IDENTITY, identity));
  }

  /** A socket address, big-endian. */
  static byte[] socket(InetSocketAddress address) {
    byte[] host = address.getAddress().getAddress();
    return new LittleEndian()
        .u16BigEndian(INTERNET)
        .u16BigEndian(address.getPort())
        .bytes(host.length == 4 ? host : new byte[4])
        .bytes(new byte[8])
        .toArray();
  }

  /** A message of items only. */
  static ByteBuffer items(PacketItem... items) {
    return PacketItem.encode(new LittleEndian(), List.of(items)).toBuffer();
  }
}
