package org.pendant.command.doctor;

import static org.pendant.command.doctor.DoctorTexts.text;

import java.util.List;

/**
 * Standard port of a control box that {@code pendant serve} opens.
 *
 * @param protocol as people call it
 * @param udp datagrams rather than connections
 */
record StandardPort(int number, FindingText protocol, boolean udp) {
  private static final FindingText ETHERNET_IP = FindingText.of("EtherNet/IP");

  static final List<StandardPort> ALL =
      List.of(
          tcp(502, FindingText.of("Modbus")),
          new StandardPort(2222, ETHERNET_IP, true),
          tcp(29_999, text("dashboard")),
          tcp(30_001, text("primary")),
          tcp(30_002, text("secondary")),
          tcp(30_003, text("realTime")),
          tcp(30_004, FindingText.of("RTDE")),
          tcp(30_011, text("primaryForReading")),
          tcp(30_012, text("secondaryForReading")),
          tcp(30_013, text("realTimeForReading")),
          tcp(30_020, text("interpreterMode")),
          tcp(40_000, text("assemblies")),
          tcp(44_818, ETHERNET_IP),
          new StandardPort(44_818, ETHERNET_IP, true));

  private static StandardPort tcp(int number, FindingText protocol) {
    return new StandardPort(number, protocol, false);
  }

  /** The port and what speaks there, such as {@code 30004 (RTDE)}. */
  FindingText words() {
    return text(udp ? "portOfDatagrams" : "portOfConnections", number, protocol);
  }
}
