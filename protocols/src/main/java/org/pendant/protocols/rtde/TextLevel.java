package org.pendant.protocols.rtde;

import org.pendant.controller.message.LogEntry.Level;

/** Text level: how severe the content of a text message is. */
enum TextLevel {
  EXCEPTION(0, Level.ERROR),
  ERROR(1, Level.ERROR),
  WARNING(2, Level.WARNING),
  INFO(3, Level.INFO);

  private final int number;
  private final Level logged;

  TextLevel(int number, Level logged) {
    this.number = number;
    this.logged = logged;
  }

  /** The level with this number; one that there is not counts as the mildest. */
  static TextLevel of(int number) {
    for (TextLevel level : values()) {
      if (level.number == number) {
        return level;
      }
    }
    return INFO;
  }

  /** What it is on the wire. */
  int number() {
    return number;
  }

  /** How the log calls it. */
  Level logged() {
    return logged;
  }
}
