package org.pendant.protocols.robotapi;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.language.source.ByteText;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;
import org.pendant.protocols.http.HttpReply;
import org.pendant.protocols.http.HttpStatus;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.teachpendant.LoadTrouble;
import org.pendant.protocols.teachpendant.OperationalMode;
import org.pendant.protocols.teachpendant.ProgramFile;
import org.pendant.protocols.teachpendant.RemotePendant;
import org.pendant.script.vm.ProgramState;

/**
 * Robot API handler: executes operations. An action is answered when it has taken effect, since
 * clients ask for the state right after it.
 */
final class RobotApiHandler {
  /** Of the API, that of PolyScope 10.12: clients choose their requests by it. */
  static final String VERSION = "3.1.4";

  /** Clients wait for 10 s. */
  private static final Duration PATIENCE = Duration.ofSeconds(9);

  /** How often it is looked whether an action has come about, ms. */
  private static final long LOOK_MS = 4;

  private final RemotePendant remotePendant;
  private final RemoteControl remote;

  RobotApiHandler(RemotePendant remotePendant, RemoteControl remote) {
    this.remotePendant = remotePendant;
    this.remote = remote;
  }

  /**
   * Carries out an operation that transfers no program; may wait.
   *
   * @param body of the request
   */
  HttpReply answer(Operation operation, ByteBuffer body) throws InterruptedException {
    try {
      return switch (operation) {
        case DESCRIPTION -> ApiReply.of(description());
        case ROBOT_MODE -> mode(robotMode(safety().robotMode()));
        case SAFETY_MODE -> mode(safetyMode(safety().safetyMode()));
        case CHANGE_ROBOT -> changeRobot(text(body, "action"));
        case PROGRAM_STATE -> ApiReply.of(program("the program is " + playState()));
        case CHANGE_PROGRAM -> changeProgram(text(body, "action"));
        case LOADED ->
            ApiReply.of(
                new JsonText()
                    .with(
                        "name",
                        remotePendant
                            .loaded()
                            .map(each -> ProgramFile.bareName(ByteText.decoded(each.name())))
                            .orElse("")));
        case LOAD -> load(text(body, "name"));
        case LOAD_AS_BEFORE -> load(text(body, "programName"));
        case PROGRAMS -> programs();
        case UPLOAD, UPDATE, DOWNLOAD ->
            throw new IllegalArgumentException(operation + " is for ProgramTransfers");
        case CONTROL_MODE -> mode(remote.mayControl() ? "REMOTE" : "LOCAL");
        case OPERATIONAL_MODE ->
            mode(
                remotePendant.operationalMode() == OperationalMode.MANUAL ? "MANUAL" : "AUTOMATIC");
      };
    } catch (JsonException e) {
      return invalid(e.getMessage());
    }
  }

  private static JsonText description() {
    Map<String, JsonText> paths = new LinkedHashMap<>();
    for (Operation each : Operation.values()) {
      paths
          .computeIfAbsent(each.path(), _ -> new JsonText())
          .with(each.method().toLowerCase(Locale.ROOT), summary(each));
    }
    JsonText all = new JsonText();
    paths.forEach(all::with);
    return new JsonText()
        .with("openapi", "3.1.0")
        .with("info", new JsonText().with("title", "Robot API").with("version", VERSION))
        .with("servers", List.of(new JsonText().with("url", RobotApi.ADDRESS)))
        .with("paths", all);
  }

  private static JsonText summary(Operation operation) {
    return new JsonText().with("summary", operation.summary());
  }

  private ControllerState state() {
    return remotePendant.state();
  }

  private SafetyStatus safety() {
    return state().safety();
  }

  private static HttpReply mode(String mode) {
    return ApiReply.of(new JsonText().with("mode", mode).with("message", "the mode is " + mode));
  }

  private static String robotMode(RobotMode mode) {
    return mode == RobotMode.UPDATING_FIRMWARE ? "UPDATING" : mode.name();
  }

  /** In the words of the API, as far as it has one. */
  private static String safetyMode(SafetyMode mode) {
    return switch (mode) {
      case SYSTEM_EMERGENCY_STOP, ROBOT_EMERGENCY_STOP -> "EMERGENCY_STOP";
      case VIOLATION, FAULT -> "FAULT";
      case NORMAL,
          REDUCED,
          PROTECTIVE_STOP,
          RECOVERY,
          SAFEGUARD_STOP,
          VALIDATE_JOINT_ID,
          UNDEFINED,
          AUTOMATIC_MODE_SAFEGUARD_STOP,
          SYSTEM_THREE_POSITION_ENABLING_STOP,
          TEACH_PENDANT_THREE_POSITION_ENABLING_STOP ->
          mode.name();
    };
  }

  private HttpReply changeRobot(String action) throws InterruptedException {
    return switch (action) {
      case "POWER_ON" ->
          changed(
              "power on",
              remotePendant.ask(new SafetyCommand.PowerOn()),
              now ->
                  now.safety().robotMode() == RobotMode.IDLE
                      || now.safety().robotMode() == RobotMode.RUNNING);
      case "POWER_OFF" ->
          changed("power off", remotePendant.ask(new SafetyCommand.PowerOff()), this::off);
      case "BRAKE_RELEASE" ->
          changed(
              "brake release",
              remotePendant.ask(new SafetyCommand.ReleaseBrakes()),
              now -> now.safety().robotMode() == RobotMode.RUNNING);
      case "UNLOCK_PROTECTIVE_STOP" ->
          changed(
              "unlock protective stop",
              remotePendant.ask(new SafetyCommand.UnlockProtectiveStop(true)),
              now -> now.safety().safetyMode() != SafetyMode.PROTECTIVE_STOP);
      case "RESTART_SAFETY" -> changed("restart safety", restartSafety(), this::off);
      default ->
          unknown(
              action,
              "POWER_ON, POWER_OFF, BRAKE_RELEASE, UNLOCK_PROTECTIVE_STOP or RESTART_SAFETY");
    };
  }

  private boolean off(ControllerState now) {
    return now.safety().robotMode() == RobotMode.POWER_OFF;
  }

  /** The arm is off afterwards, whether there was something to end or not. */
  private Reply restartSafety() {
    Reply reply = remotePendant.ask(new SafetyCommand.RestartSafety());
    return reply.complaint().isPresent() ? remotePendant.ask(new SafetyCommand.PowerOff()) : reply;
  }

  /** Answers when an action has come about. */
  private HttpReply changed(String action, Reply reply, Predicate<ControllerState> wanted)
      throws InterruptedException {
    Optional<String> complaint = reply.complaint();
    if (complaint.isPresent()) {
      return conflict(action, complaint.get());
    }
    long begunNs = System.nanoTime();
    while (!wanted.test(state())) {
      if (System.nanoTime() - begunNs > PATIENCE.toNanos()) {
        return ApiReply.refused(
            HttpStatus.GATEWAY_TIMEOUT,
            action + " is under way",
            "it has not come about within " + PATIENCE.toSeconds() + " s");
      }
      TimeUnit.MILLISECONDS.sleep(LOOK_MS);
    }
    return ApiReply.of(
        new JsonText()
            .with("state", robotMode(safety().robotMode()))
            .with("message", action + " is done"));
  }

  private HttpReply changeProgram(String action) {
    return switch (action) {
      case "play" -> moved(action, remotePendant.play());
      case "pause" -> moved(action, remotePendant.pause());
      case "resume" ->
          moved(
              action,
              state().program().state() == ProgramState.PAUSED
                  ? remotePendant.play()
                  : new Reply.Refused(
                      Refusal.Code.PROGRAM, "the program is " + playState() + ", must be PAUSED"));
      case "stop" -> moved(action, remotePendant.stop());
      default -> unknown(action, "play, pause, resume or stop");
    };
  }

  private HttpReply moved(String action, Reply reply) {
    Optional<String> complaint = reply.complaint();
    return complaint.isPresent()
        ? conflict(action, complaint.get())
        : ApiReply.of(program(action + " is done"));
  }

  private JsonText program(String message) {
    return new JsonText().with("state", playState()).with("message", message);
  }

  private String playState() {
    return switch (state().program().state()) {
      case STOPPED -> "STOPPED";
      case RUNNING -> "PLAYING";
      case PAUSED -> "PAUSED";
    };
  }

  private HttpReply load(String name) {
    try {
      String loaded = remotePendant.loadNamed(ByteText.asBytes(name)).name();
      return ApiReply.of(
          new JsonText()
              .with("name", ProgramFile.bareName(ByteText.decoded(loaded)))
              .with("message", "the program is loaded"));
    } catch (LoadTrouble e) {
      return ApiReply.refused(
          e.missing() ? HttpStatus.NOT_FOUND : HttpStatus.UNPROCESSABLE,
          e.missing() ? "Program not found" : "Program cannot be loaded",
          ByteText.decoded(e.getMessage()));
    }
  }

  /** Of files with one name the first is the one that is loaded by it. */
  private HttpReply programs() {
    Map<String, JsonText> byName = new LinkedHashMap<>();
    try {
      for (ProgramFile each : remotePendant.programs()) {
        String name = ProgramFile.bareName(each.name());
        byName.putIfAbsent(
            name,
            new JsonText()
                .with("name", name)
                .with("description", "")
                .with("createdDate", each.created().getEpochSecond())
                .with("lastModifiedDate", each.modified().getEpochSecond())
                .with("lastSavedDate", each.modified().getEpochSecond())
                .with("programState", "FINAL"));
      }
    } catch (IOException e) {
      return ApiReply.refused(
          HttpStatus.INTERNAL, "The programs cannot be listed", String.valueOf(e.getMessage()));
    }
    return ApiReply.of(
        new JsonText()
            .with("programs", List.copyOf(byName.values()))
            .with("message", byName.size() + " programs"));
  }

  private static HttpReply conflict(String action, String reason) {
    return ApiReply.refused(
        HttpStatus.CONFLICT, action + " is not possible now", ByteText.decoded(reason));
  }

  private static HttpReply unknown(String action, String known) {
    return invalid("action is " + Json.quoted(action) + ", must be " + known);
  }

  private static HttpReply invalid(String reason) {
    return ApiReply.refused(HttpStatus.UNPROCESSABLE, "Validation Error", reason);
  }

  /** The text that the object in {@code body} has at {@code key}. */
  private static String text(ByteBuffer body, String key) throws JsonException {
    byte[] bytes = new byte[body.remaining()];
    body.get(bytes);
    Json object = JsonFile.read("body", new ByteArrayInputStream(bytes));
    return new JsonFields(object, "the body").text(key).value();
  }
}
