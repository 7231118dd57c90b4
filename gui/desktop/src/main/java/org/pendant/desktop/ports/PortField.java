package org.pendant.desktop.ports;

import static org.pendant.desktop.ports.PortsTexts.text;

import org.pendant.command.service.PortWishes;

/** Port field: what people type to say where the ports are. */
enum PortField {
  HOST("host", text("address"), text("whereToListen12700")),
  OFFSET("offset", text("offset"), text("isAddedToEveryPort0", PortWishes.MAX_OFFSET)),
  MODBUS("modbus", text("modbusPort"), text("emptyFor502AndTheOffset")),
  PROGRAMS("programs", text("programsFolder"), text("theFolderFromWhichClientsLoad"));

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
