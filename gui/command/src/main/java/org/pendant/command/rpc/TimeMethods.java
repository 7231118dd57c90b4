package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.pendant.controller.message.Popup;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.json.Json;
import org.pendant.models.json.Range;
import org.pendant.models.time.FrameTime;
import org.pendant.script.vm.ProgramState;

/** The method {@code advance}, the only one in which robot time passes. */
final class TimeMethods {
  /** Robot time of one call at most. */
  private static final double MAX_S = 86_400;

  /** Robot time after which a wait for the end of a program ends. */
  private static final double END_TIMEOUT_S = 3_600;

  /** Robot time after which a wait for a condition ends. */
  private static final double CONDITION_TIMEOUT_S = 60;

  /** Time on the wall after which a call ends. */
  private static final double STANDARD_WALL_S = 600;

  private static final long MAX_FRAMES = Math.round(MAX_S / FrameTime.FRAME_S);
  private static final Range SECONDS = new Range(0, MAX_S, "s");
  private static final int FRAMES_PER_LOOK = 64;

  private TimeMethods() {}

  static void declareIn(MethodTable table) {
    table.add(
        "advance",
        List.of("seconds", "frames", "until", "timeout", "wall", "state"),
        TimeMethods::advance);
  }

  /** What a call waits for. */
  @FunctionalInterface
  private interface Goal {
    /** Why the call ends with this snapshot; empty if it does not. */
    Optional<String> reached(ControllerState state) throws RpcFailure;
  }

  private static Object advance(DrivenRobot robot, RpcParams params) throws RpcFailure {
    OptionalDouble seconds = params.number("seconds", SECONDS);
    OptionalLong frames = params.whole("frames", 0, MAX_FRAMES);
    Optional<Json> until = params.get("until");
    int given =
        (seconds.isPresent() ? 1 : 0) + (frames.isPresent() ? 1 : 0) + (until.isPresent() ? 1 : 0);
    if (given != 1) {
      throw RpcFailure.params(text("secondsFramesOrUntil"));
    }
    OptionalDouble timeout = params.number("timeout", SECONDS);
    if (timeout.isPresent() && until.isEmpty()) {
      throw RpcFailure.params(text("timeoutWithUntil"));
    }
    Goal goal = until.isPresent() ? goal(until.get(), robot) : state -> Optional.empty();
    double standardS =
        until.filter(Json.Text.class::isInstance).isPresent() ? END_TIMEOUT_S : CONDITION_TIMEOUT_S;
    long most =
        frames.orElse(Math.round(seconds.orElse(timeout.orElse(standardS)) / FrameTime.FRAME_S));
    double wallS = params.number("wall", SECONDS).orElse(STANDARD_WALL_S);
    long before = robot.state().frame();
    String reason =
        advance(robot, most, wallS, goal).orElse(until.isPresent() ? "timeout" : "time");
    Map<String, Object> answer = new LinkedHashMap<>();
    answer.put("reason", reason);
    answer.put("frames", robot.state().frame() - before);
    if (params.flag("state").orElse(true)) {
      answer.put("state", StateRecord.of(robot.state(), robot.startedFile()));
    }
    return answer;
  }

  private static Optional<String> advance(DrivenRobot robot, long most, double wallS, Goal goal)
      throws RpcFailure {
    long beganNs = System.nanoTime();
    Optional<String> reason = goal.reached(robot.state());
    for (long i = 0; i < most && reason.isEmpty(); i++) {
      if (i % FRAMES_PER_LOOK == FRAMES_PER_LOOK - 1 && System.nanoTime() - beganNs > wallS * 1e9) {
        throw new RpcFailure(
            RpcFailure.WALL_TIME,
            text("wallTimeOver", Range.number(wallS), Range.number(robot.state().timeS())),
            Map.of("frames", i));
      }
      robot.advance();
      reason = goal.reached(robot.state());
    }
    return reason;
  }

  private static Goal goal(Json until, DrivenRobot robot) throws RpcFailure {
    if (!(until instanceof Json.Text word)) {
      Condition condition = Condition.of(until);
      return state ->
          condition.holds(state, robot.drive()) ? Optional.of("condition") : Optional.empty();
    }
    return switch (word.value()) {
      case "ended" -> TimeMethods::ended;
      case "rest" ->
          state ->
              state.program().state() != ProgramState.RUNNING && !state.arm().moving()
                  ? Optional.of("rest")
                  : Optional.empty();
      default -> throw RpcParams.wrong("until", until, text("goalOrObject"));
    };
  }

  /** The end of the program, and what keeps it from ending without an operator. */
  private static Optional<String> ended(ControllerState state) {
    if (state.program().state() == ProgramState.STOPPED) {
      return Optional.of("ended");
    }
    if (!state.openQuestions().isEmpty()) {
      return Optional.of("question");
    }
    if (state.openPopups().stream().anyMatch(Popup::blocking)) {
      return Optional.of("popup");
    }
    return state.program().state() == ProgramState.PAUSED
        ? Optional.of("paused")
        : Optional.empty();
  }
}
