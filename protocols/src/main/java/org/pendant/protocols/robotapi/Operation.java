package org.pendant.protocols.robotapi;

import java.util.Optional;

/** Operation that clients can ask for. */
enum Operation {
  DESCRIPTION("GET", "/openapi.json", "What there is"),
  ROBOT_MODE("GET", "/robotstate/v1/robotmode", "The robot mode"),
  SAFETY_MODE("GET", "/robotstate/v1/safetymode", "The safety mode"),
  CHANGE_ROBOT("PUT", "/robotstate/v1/state", "Power, brakes, unlocking: {\"action\": ...}"),
  PROGRAM_STATE("GET", "/program/v1/state", "Whether the program plays"),
  CHANGE_PROGRAM("PUT", "/program/v1/state", "Play, pause, resume, stop: {\"action\": ...}"),
  LOADED("GET", "/program/v1/loaded", "The name of the loaded program"),
  LOAD("PUT", "/program/v1/loaded", "Load a program: {\"name\": ...}"),
  LOAD_AS_BEFORE("PUT", "/program/v1/load", "Load a program: {\"programName\": ...}"),
  PROGRAMS("GET", "/programs/v1", "The programs that can be loaded"),
  UPLOAD("POST", "/programs/v1", "Add a program of PolyScope X: the part \"file\" of a form"),
  UPDATE("PUT", "/programs/v1", "Replace a program: the part \"file\" of a form"),
  DOWNLOAD("GET", "/programs/v1/{name}", "A program of PolyScope X"),
  CONTROL_MODE("GET", "/system/v1/controlmode", "Whether the outside may control the robot"),
  OPERATIONAL_MODE("GET", "/system/v1/operationalmode", "Automatic or manual");

  private final String method;
  private final String path;
  private final String summary;

  Operation(String method, String path, String summary) {
    this.method = method;
    this.path = path;
    this.summary = summary;
  }

  /** The method of HTTP. */
  String method() {
    return method;
  }

  /** Below the address of the API, without a slash at its end. */
  String path() {
    return path;
  }

  /** What it does, for people. */
  String summary() {
    return summary;
  }

  /** Whether it changes anything. */
  boolean changes() {
    return !method.equals("GET");
  }

  /** Whether it changes what robot and program do. */
  boolean acts() {
    return changes() && !transfers();
  }

  /** Whether a program is taken or given. */
  boolean transfers() {
    return this == UPLOAD || this == UPDATE || this == DOWNLOAD;
  }

  /** The operation with that method; empty if there is none at this path. */
  static Optional<Operation> of(String method, String path) {
    for (Operation each : values()) {
      if (each.method.equals(method) && each.isAt(path)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  /** Whether a path leads here; a name in it is as the client likes. */
  boolean isAt(String wanted) {
    int name = path.indexOf('{');
    return name < 0
        ? path.equals(wanted)
        : wanted.startsWith(path.substring(0, name)) && wanted.indexOf('/', name) < 0;
  }

  /** The name in a path that leads here, as it was sent. */
  String nameIn(String wanted) {
    return wanted.substring(path.indexOf('{'));
  }
}
