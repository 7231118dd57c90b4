package org.pendant.protocols.dashboard;

import java.util.List;

/** Dashboard command: what can be asked of the dashboard server. */
enum DashboardCommand {
  LOAD_INSTALLATION("load installation", Effect.ACTS, Argument.TAKEN),
  LOAD("load", Effect.ACTS, Argument.TAKEN),
  PLAY("play", Effect.ACTS, Argument.NONE),
  STOP("stop", Effect.ACTS, Argument.NONE),
  PAUSE("pause", Effect.ACTS, Argument.NONE),
  QUIT("quit", Effect.ASKS, Argument.NONE),
  SHUTDOWN("shutdown", Effect.ACTS, Argument.NONE),
  RUNNING("running", Effect.ASKS, Argument.NONE),
  ROBOT_MODE("robotmode", Effect.ASKS, Argument.NONE),
  GET_LOADED_PROGRAM("get loaded program", Effect.ASKS, Argument.NONE),
  POPUP("popup", Effect.ASKS, Argument.TAKEN),
  CLOSE_POPUP("close popup", Effect.ASKS, Argument.NONE),
  CLOSE_SAFETY_POPUP("close safety popup", Effect.ACTS, Argument.NONE),
  ADD_TO_LOG("addtolog", Effect.ASKS, Argument.TAKEN),
  IS_PROGRAM_SAVED("isprogramsaved", Effect.ASKS, Argument.NONE),
  PROGRAM_STATE("programstate", Effect.ASKS, Argument.NONE),
  POLYSCOPE_VERSION("polyscopeversion", Effect.ASKS, Argument.NONE),
  VERSION("version", Effect.ASKS, Argument.NONE),
  SET_OPERATIONAL_MODE("set operational mode", Effect.ACTS, Argument.TAKEN),
  GET_OPERATIONAL_MODE("get operational mode", Effect.ASKS, Argument.NONE),
  CLEAR_OPERATIONAL_MODE("clear operational mode", Effect.ACTS, Argument.NONE),
  POWER_ON("power on", Effect.ACTS, Argument.NONE),
  POWER_OFF("power off", Effect.ACTS, Argument.NONE),
  BRAKE_RELEASE("brake release", Effect.ACTS, Argument.NONE),
  SAFETY_STATUS("safetystatus", Effect.ASKS, Argument.NONE),
  SAFETY_MODE("safetymode", Effect.ASKS, Argument.NONE),
  UNLOCK_PROTECTIVE_STOP("unlock protective stop", Effect.ACTS, Argument.NONE),
  RESTART_SAFETY("restart safety", Effect.ACTS, Argument.NONE),
  IS_IN_REMOTE_CONTROL("is in remote control", Effect.ASKS, Argument.NONE),
  GET_SERIAL_NUMBER("get serial number", Effect.ASKS, Argument.NONE),
  GET_ROBOT_MODEL("get robot model", Effect.ASKS, Argument.NONE),
  GENERATE_FLIGHT_REPORT("generate flight report", Effect.ASKS, Argument.TAKEN),
  GENERATE_SUPPORT_FILE("generate support file", Effect.ASKS, Argument.TAKEN),
  SAVE_LOG("savelog", Effect.ASKS, Argument.NONE);

  /** Whether it changes what robot and program do. */
  private enum Effect {
    ACTS,
    ASKS
  }

  private enum Argument {
    TAKEN,
    NONE
  }

  private final String words;
  private final Effect effect;
  private final Argument argument;

  DashboardCommand(String words, Effect effect, Argument argument) {
    this.words = words;
    this.effect = effect;
    this.argument = argument;
  }

  /** Its words, in lower case. */
  List<String> words() {
    return List.of(words.split(" "));
  }

  /** Whether it is refused in local control. */
  boolean acts() {
    return effect == Effect.ACTS;
  }

  /** Whether people see it on the box, although it is not refused in local control. */
  boolean shows() {
    return this == POPUP || this == CLOSE_POPUP || this == ADD_TO_LOG;
  }

  /** Whether something may follow the words. */
  boolean takesArgument() {
    return argument == Argument.TAKEN;
  }
}
