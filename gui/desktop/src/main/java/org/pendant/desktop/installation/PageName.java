package org.pendant.desktop.installation;

/** Page name: the pages of the Installation screen, in the order of their list. */
enum PageName {
  TCP("General", "tcp", "TCP"),
  PAYLOAD("General", "payload", "Payload"),
  MOUNTING("General", "mounting", "Mounting"),
  SIGNALS("General", "signals", "I/O"),
  HOME("General", "home", "Home"),
  VARIABLES("General", "variables", "Variables"),
  START_UP("General", "start-up", "Start-up"),
  CONVEYORS("General", "conveyors", "Conveyors"),
  TOOL_CONNECTOR("General", "tool-connector", "Tool connector"),
  LIMITS("Safety", "limits", "Limits"),
  JOINT_LIMITS("Safety", "joint-limits", "Joints"),
  PLANES("Safety", "planes", "Planes"),
  TOOL_DIRECTION("Safety", "tool-direction", "Tool direction"),
  FEATURES("Features", "features", "Features"),
  MODBUS("Fieldbus", "modbus", "Modbus"),
  ETHERNET_IP("Fieldbus", "ethernet-ip", "EtherNet/IP"),
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
