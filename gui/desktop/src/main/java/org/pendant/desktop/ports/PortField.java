package org.pendant.desktop.ports;

import org.pendant.command.service.PortWishes;

/** Port field: what people type to say where the ports are. */
enum PortField {
  HOST("host", "Address", "Where to listen: 127.0.0.1 for this computer only"),
  OFFSET("offset", "Offset", "Is added to every port, 0 to " + PortWishes.MAX_OFFSET),
  MODBUS("modbus", "Modbus port", "Empty for 502 and the offset, or 1502 without the right"),
  PROGRAMS("programs", "Programs folder", "The folder from which clients load programs");

  private final String word;
  private final String title;
  private final String meaning;

  PortField(String word, String title, String meaning) {
    this.word = word;
    this.title = title;
    this.meaning = meaning;
  }

  /** Stable name, in settings and of the component. */
  String word() {
    return word;
  }

  /** What people read beside it. */
  String title() {
    return title;
  }

  /** What it is for. */
  String meaning() {
    return meaning;
  }
}
