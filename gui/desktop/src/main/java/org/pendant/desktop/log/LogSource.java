package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import org.pendant.controller.message.LogEntry.Origin;

/** Log source: who a message is from, as people see it. */
enum LogSource {
  PROGRAM(text("program"), text("whatProgramsWriteAndWhyThey")),
  CONTROLLER(text("controller"), text("whatTheControllerSays")),
  SAFETY(text("safety"), text("stopsWarningsAndChangesOfMode")),
  ROBOT(text("robot"), text("powerAndBrakesProgramsThatStart")),
  PROTOCOL(text("protocol"), text("whatComesFromOutsideByA")),
  WINDOW(text("window"), text("whatThisWindowToldAtIts"));

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
