package org.pendant.protocols.robotapi;

import java.util.Optional;

/** What clients can ask for. */
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

  /** Whether it changes what robot and program do. */
  boolean acts() {
    return method.equals("PUT");
  }

  /** The operation with that method; empty if there is none at this path. */
  static Optional<Operation> of(String method, String path) {
    for (Operation each : values()) {
      if (each.method.equals(method) && each.path.equals(path)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }
}
