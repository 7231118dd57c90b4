package org.pendant.protocols.dashboard;

import static org.pendant.protocols.dashboard.DashboardTexts.text;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.SoftwareVersion;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.teachpendant.LoadTrouble;
import org.pendant.protocols.teachpendant.LoadedProgram;
import org.pendant.protocols.teachpendant.OperationalMode;
import org.pendant.protocols.teachpendant.RemotePendant;
import org.pendant.script.vm.ProgramState;

/**
 * Dashboard handler: executes a request and answers in the words of the real box. Details that an
 * answer has no words for, such as why a program does not start, go to the log.
 */
final class DashboardHandler {
  private static final String UNNAMED = "<unnamed>";
  private static final List<String> REPORT_TYPES = List.of("", "controller", "software", "system");

  private final RemotePendant remotePendant;
  private final RemoteControl remote;
  private final PeerLog log;

  DashboardHandler(RemotePendant remotePendant, RemoteControl remote, PeerLog log) {
    this.remotePendant = remotePendant;
    this.remote = remote;
    this.log = log;
  }

  /** Carries out a request; may wait. */
  String answer(DashboardRequest request) {
    String argument = request.argument();
    return switch (request.word()) {
      case LOAD -> load(argument);
      case LOAD_INSTALLATION -> loadInstallation(argument);
      case PLAY ->
          done("play", remotePendant.play()) ? "Starting program" : "Failed to execute: play";
      case STOP -> done("stop", remotePendant.stop()) ? "Stopped" : "Failed to execute: stop";
      case PAUSE ->
          done("pause", remotePendant.pause()) ? "Pausing program" : "Failed to execute: pause";
      case QUIT -> "Disconnected";
      case SHUTDOWN -> always("shutdown", new BoxCommand.ShutDown(), "Shutting down");
      case RUNNING -> "Program running: " + (program() == ProgramState.RUNNING);
      case ROBOT_MODE -> "Robotmode: " + state().safety().robotMode();
      case GET_LOADED_PROGRAM ->
          remotePendant
              .loaded()
              .map(p -> "Loaded program: " + p.path())
              .orElse("No program loaded");
      case POPUP -> told("popup", remotePendant.showPopup(argument), "showing popup");
      case CLOSE_POPUP -> told("close popup", remotePendant.closePopup(), "closing popup");
      case CLOSE_SAFETY_POPUP -> "closing safety popup";
      case ADD_TO_LOG -> addToLog(argument);
      case IS_PROGRAM_SAVED ->
          remotePendant.loaded().map(p -> p.saved() + " " + p.name()).orElse("false " + UNNAMED);
      case PROGRAM_STATE ->
          playState() + " " + remotePendant.loaded().map(LoadedProgram::name).orElse(UNNAMED);
      case POLYSCOPE_VERSION ->
          "URSoftware "
              + SoftwareVersion.REPORTED.text()
              + " ("
              + SoftwareVersion.REPORTED.buildDate()
              + ")";
      case VERSION -> SoftwareVersion.REPORTED.text();
      case SET_OPERATIONAL_MODE -> setOperationalMode(argument);
      case GET_OPERATIONAL_MODE -> remotePendant.operationalMode().name();
      case CLEAR_OPERATIONAL_MODE -> clearOperationalMode();
      case POWER_ON -> always("power on", new SafetyCommand.PowerOn(), "Powering on");
      case POWER_OFF -> always("power off", new SafetyCommand.PowerOff(), "Powering off");
      case BRAKE_RELEASE ->
          always("brake release", new SafetyCommand.ReleaseBrakes(), "Brake releasing");
      case SAFETY_STATUS ->
          "Safetystatus: " + SafetyModeNames.status(state().safety().safetyMode());
      case SAFETY_MODE -> "Safetymode: " + SafetyModeNames.mode(state().safety().safetyMode());
      case UNLOCK_PROTECTIVE_STOP -> unlockProtectiveStop();
      case RESTART_SAFETY -> restartSafety();
      case IS_IN_REMOTE_CONTROL -> String.valueOf(remote.remote());
      case GET_SERIAL_NUMBER -> remotePendant.identity().serialNumber();
      case GET_ROBOT_MODEL -> remotePendant.identity().model();
      case GENERATE_FLIGHT_REPORT -> flightReport(argument);
      case GENERATE_SUPPORT_FILE -> supportFile(argument);
      case SAVE_LOG -> saveLog();
    };
  }

  private ControllerState state() {
    return remotePendant.state();
  }

  private ProgramState program() {
    return state().program().state();
  }

  private String playState() {
    return switch (program()) {
      case STOPPED -> "STOPPED";
      case RUNNING -> "PLAYING";
      case PAUSED -> "PAUSED";
    };
  }

  /** Whether there is no refusal; one is logged. */
  private boolean done(String what, Reply reply) {
    Optional<String> complaint = reply.complaint();
    complaint.ifPresent(why -> log.write(Level.WARNING, text("commandRefused", what, why)));
    return complaint.isEmpty();
  }

  /** The one answer there is, whatever comes of it; a refusal is logged. */
  private String told(String what, Reply reply, String answer) {
    var _ = done(what, reply);
    return answer;
  }

  private String always(String what, Command command, String answer) {
    return told(what, remotePendant.ask(command), answer);
  }

  private String load(String name) {
    try {
      remotePendant.load(name);
      return "Loading program: " + name;
    } catch (LoadTrouble e) {
      return trouble(e, name, "Error while loading program: ");
    }
  }

  private String loadInstallation(String name) {
    try {
      remotePendant.loadInstallation(name);
      return "Loading installation: " + name;
    } catch (LoadTrouble e) {
      return trouble(e, name, "Failed to load installation: ");
    }
  }

  private String trouble(LoadTrouble trouble, String name, String broken) {
    log.write(Level.WARNING, text("commandRefused", "load", trouble.getMessage()));
    return (trouble.missing() ? "File not found: " : broken) + name;
  }

  private String addToLog(String text) {
    if (text.isEmpty()) {
      return "No log message to add";
    }
    log.write(Level.INFO, text);
    return "Added log message";
  }

  private String setOperationalMode(String argument) {
    Optional<OperationalMode> wanted =
        switch (argument.toLowerCase(Locale.ROOT)) {
          case "manual" -> Optional.of(OperationalMode.MANUAL);
          case "automatic" -> Optional.of(OperationalMode.AUTOMATIC);
          default -> Optional.empty();
        };
    if (wanted.isEmpty()) {
      return "Failed setting operational mode: " + argument;
    }
    remotePendant.setOperationalMode(wanted.get());
    return "Operational mode '" + argument + "' is set";
  }

  private String clearOperationalMode() {
    remotePendant.setOperationalMode(OperationalMode.NONE);
    return "No longer controlling the operational mode. Current operational mode: '"
        + remotePendant.operationalMode()
        + "'.";
  }

  private String unlockProtectiveStop() {
    boolean stopped = state().safety().safetyMode() == SafetyMode.PROTECTIVE_STOP;
    boolean unlocked =
        done(
            "unlock protective stop",
            remotePendant.ask(new SafetyCommand.UnlockProtectiveStop(false)));
    return unlocked || !stopped
        ? "Protective stop releasing"
        : "Cannot unlock protective stop until 5s after occurrence."
            + " Always inspect cause of protective stop before unlocking";
  }

  /** The arm is off afterwards, whether there was something to end or not. */
  private String restartSafety() {
    if (remotePendant.ask(new SafetyCommand.RestartSafety()).complaint().isPresent()) {
      return always("restart safety", new SafetyCommand.PowerOff(), "Restarting safety");
    }
    return "Restarting safety";
  }

  private String flightReport(String type) {
    if (!REPORT_TYPES.contains(type.toLowerCase(Locale.ROOT))) {
      return "Error: type is " + type + ", must be controller, software or system";
    }
    try {
      return "Flight Report generated with id: " + remotePendant.reports().flightReport();
    } catch (IOException e) {
      return "Error: " + e.getMessage();
    }
  }

  private String supportFile(String directory) {
    try {
      return "Completed successfully: " + remotePendant.reports().supportFile(directory);
    } catch (IOException e) {
      return "Error: " + e.getMessage();
    }
  }

  private String saveLog() {
    try {
      remotePendant.reports().saveLog();
      return "Log saved to disk";
    } catch (IOException e) {
      return "Error: " + e.getMessage();
    }
  }
}
