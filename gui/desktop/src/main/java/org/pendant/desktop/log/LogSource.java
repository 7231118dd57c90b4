package org.pendant.desktop.log;

import org.pendant.controller.message.LogEntry.Origin;

/** Log source: who a message is from, as people see it. */
enum LogSource {
  PROGRAM("Program", "what programs write, and why they end"),
  CONTROLLER("Controller", "what the controller says"),
  SAFETY("Safety", "stops, warnings and changes of mode of the safety functions"),
  ROBOT(
      "Robot", "power and brakes, programs that start, pause and end, clients that come and leave"),
  PROTOCOL("Protocol", "what comes from outside by a protocol"),
  WINDOW("Window", "what this window told at its lower edge");

  private final String title;
  private final String meaning;

  LogSource(String title, String meaning) {
    this.title = title;
    this.meaning = meaning;
  }

  static LogSource of(Origin origin) {
    return switch (origin) {
      case SCRIPT, ENDING -> PROGRAM;
      case CONTROLLER -> CONTROLLER;
      case SAFETY -> SAFETY;
      case PROTOCOL -> PROTOCOL;
    };
  }

  /** What people call it. */
  String title() {
    return title;
  }

  /** What comes from there. */
  String meaning() {
    return meaning;
  }
}
