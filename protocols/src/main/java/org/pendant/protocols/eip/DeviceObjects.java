package org.pendant.protocols.eip;

import java.net.InetAddress;
import java.util.List;
import java.util.Map;
import java.util.function.IntSupplier;

/** Device objects: those that every device has, and what they tell about a box. */
final class DeviceObjects {
  static final int IDENTITY = 0x01;
  static final int MESSAGE_ROUTER = 0x02;
  static final int ASSEMBLY = 0x04;
  static final int CONNECTION_MANAGER = 0x06;
  static final int TCP_IP = 0xF5;
  static final int ETHERNET_LINK = 0xF6;

  private static final int CONFIGURED = 1;
  private static final int LOOPBACK_MASK = 0xFF00_0000;
  private static final int SPEED_MBIT_PER_S = 1000;
  private static final int LINK_UP_FULL_DUPLEX = 3;

  /** Locally administered: there is no wire. */
  private static final byte[] MAC = {0x02, 0x55, 0x52, 0x00, 0x00, 0x01};

  private DeviceObjects() {}

  /**
   * By the numbers of their classes, without assemblies and connection manager.
   *
   * @param status of the device, as the identity object has it
   */
  static Map<Integer, CipObject> of(InetAddress host, IntSupplier status) {
    DeviceIdentity own = DeviceIdentity.OWN;
    CipObject identity =
        new SingleObject(
            1,
            List.of(
                () -> new LittleEndian().u16(own.vendor()),
                () -> new LittleEndian().u16(own.deviceType()),
                () -> new LittleEndian().u16(own.productCode()),
                () -> new LittleEndian().u8(own.major()).u8(own.minor()),
                () -> new LittleEndian().u16(status.getAsInt()),
                () -> new LittleEndian().u32(own.serial()),
                () -> new LittleEndian().shortText(own.name())));
    CipObject router =
        new SingleObject(
            1,
            List.of(
                DeviceObjects::classes,
                () -> new LittleEndian().u16(Connections.MAX_EXPLICIT),
                () -> new LittleEndian().u16(0)));
    CipObject tcpIp =
        new SingleObject(
            1,
            List.of(
                () -> new LittleEndian().u32(CONFIGURED),
                () -> new LittleEndian().u32(0),
                () -> new LittleEndian().u32(0),
                () -> new LittleEndian().u16(2).u8(0x20).u8(ETHERNET_LINK).u8(0x24).u8(1),
                () -> network(host),
                () -> new LittleEndian().u16(0)));
    CipObject link =
        new SingleObject(
            1,
            List.of(
                () -> new LittleEndian().u32(SPEED_MBIT_PER_S),
                () -> new LittleEndian().u32(LINK_UP_FULL_DUPLEX),
                () -> new LittleEndian().bytes(MAC)));
    return Map.of(IDENTITY, identity, MESSAGE_ROUTER, router, TCP_IP, tcpIp, ETHERNET_LINK, link);
  }

  private static LittleEndian classes() {
    List<Integer> classes =
        List.of(IDENTITY, MESSAGE_ROUTER, ASSEMBLY, CONNECTION_MANAGER, TCP_IP, ETHERNET_LINK);
    LittleEndian out = new LittleEndian().u16(classes.size());
    classes.forEach(out::u16);
    return out;
  }

  /** Address, mask, gateway, two name servers, domain. */
  private static LittleEndian network(InetAddress host) {
    byte[] address = host.getAddress();
    LittleEndian out = new LittleEndian();
    for (int i = 3; i >= 0; i--) {
      out.u8(address.length == 4 ? address[i] : 0);
    }
    return out.u32(host.isLoopbackAddress() ? LOOPBACK_MASK : 0).u32(0).u32(0).u32(0).u16(0);
  }
}
