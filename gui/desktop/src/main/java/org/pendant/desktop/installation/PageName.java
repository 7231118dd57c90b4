package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

/** Page name: the pages of the Installation screen, in the order of their list. */
enum PageName {
  TCP(text("general"), "tcp", "TCP"),
  PAYLOAD(text("general"), "payload", text("payload")),
  MOUNTING(text("general"), "mounting", text("mounting")),
  SIGNALS(text("general"), "signals", text("io")),
  HOME(text("general"), "home", text("home")),
  VARIABLES(text("general"), "variables", text("variables")),
  START_UP(text("general"), "start-up", text("startUp")),
  CONVEYORS(text("general"), "conveyors", text("conveyors")),
  TOOL_CONNECTOR(text("general"), "tool-connector", text("toolConnector")),
  LIMITS(text("safety"), "limits", text("limits")),
  JOINT_LIMITS(text("safety"), "joint-limits", text("joints")),
  PLANES(text("safety"), "planes", text("planes")),
  TOOL_DIRECTION(text("safety"), "tool-direction", text("toolDirection")),
  FEATURES(text("features"), "features", text("features")),
  MODBUS(text("fieldbus"), "modbus", "Modbus"),
  ETHERNET_IP(text("fieldbus"), "ethernet-ip", "EtherNet/IP"),
  EXTERNAL_CONTROL("URCaps", "external-control", "External Control");

  private final String group;
  private final String id;
  private final String title;

  PageName(String group, String id, String title) {
    this.group = group;
    this.id = id;
    this.title = title;
  }

  /** The heading below which people find it. */
  String group() {
    return group;
  }

  /** Stable name, such as {@code tcp}. */
  String id() {
    return id;
  }

  /** What people read in the list of pages. */
  String title() {
    return title;
  }
}
