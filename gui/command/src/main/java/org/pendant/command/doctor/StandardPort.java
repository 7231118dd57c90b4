package org.pendant.command.doctor;

import java.util.List;

/**
 * Standard port of a control box that {@code pendant serve} opens.
 *
 * @param protocol as people call it
 * @param udp datagrams rather than connections
 */
record StandardPort(int number, String protocol, boolean udp) {
  static final List<StandardPort> ALL =
      List.of(
          tcp(502, "Modbus"),
          new StandardPort(2222, "EtherNet/IP", true),
          tcp(29_999, "dashboard"),
          tcp(30_001, "primary"),
          tcp(30_002, "secondary"),
          tcp(30_003, "real-time"),
          tcp(30_004, "RTDE"),
          tcp(30_011, "primary, for reading"),
          tcp(30_012, "secondary, for reading"),
          tcp(30_013, "real-time, for reading"),
          tcp(30_020, "interpreter mode"),
          tcp(40_000, "assemblies of EtherNet/IP"),
          tcp(44_818, "EtherNet/IP"),
          new StandardPort(44_818, "EtherNet/IP", true));

  private static StandardPort tcp(int number, String protocol) {
    return new StandardPort(number, protocol, false);
  }

  /** The port and what speaks there, such as {@code 30004 (RTDE)}. */
  String words() {
    return "%d (%s%s)".formatted(number, protocol, udp ? ", UDP" : "");
  }
}
