package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.models.arm.Joints;
import org.pendant.models.json.Json;
import org.pendant.models.json.Range;
import org.pendant.script.function.Builtins;

/** Robots: those that there are, by handle. */
final class Robots implements AutoCloseable {
  /** The parameter that says which robot a method is about. */
  static final String HANDLE = "handle";

  /** Robots at a time at most. */
  static final int MAX_ROBOTS = 100;

  private static final long MAX_HANDLE = 1L << 53;
  private static final Range JOINT_RAD = new Range(-2 * Math.PI, 2 * Math.PI, "rad");

  /** Parameters of {@code robot.create} that are no options of the command line. */
  private static final Set<String> OWN = Set.of("start", "operator", "recording");

  private final RobotSource source;
  private final Builtins<ControlBox> builtins = StandardBuiltins.create();
  private final Map<Long, DrivenRobot> sessions = new LinkedHashMap<>();
  private long created;

  Robots(RobotSource source) {
    this.source = source;
  }

  void declareIn(MethodTable table) {
    table.add("robot.create", this::create);
    table.add(
        "robot.close",
        List.of(),
        (robot, params) -> {
          sessions.values().remove(robot);
          robot.close();
          return Map.of();
        });
    table.add(
        "robot.list",
        params -> {
          params.allow();
          return List.copyOf(sessions.keySet());
        });
  }

  /** The robot that a request is about: that of its handle, or the only one. */
  DrivenRobot of(RpcParams params) throws RpcFailure {
    OptionalLong handle = params.whole(HANDLE, 1, MAX_HANDLE);
    if (handle.isEmpty() && sessions.size() == 1) {
      return sessions.values().iterator().next();
    }
    if (handle.isEmpty()) {
      throw RpcFailure.params(text("handleMissing", sessions.size()));
    }
    DrivenRobot found = sessions.get(handle.getAsLong());
    if (found == null) {
      throw new RpcFailure(RpcFailure.NO_SUCH_ROBOT, text("noSuchRobot", handle.getAsLong()));
    }
    return found;
  }

  private Object create(RpcParams params) throws RpcFailure {
    if (sessions.size() == MAX_ROBOTS) {
      throw new RpcFailure(RpcFailure.TOO_MUCH, text("tooManyRobots", MAX_ROBOTS));
    }
    String operator = params.text("operator").orElse("present");
    if (!operator.equals("present") && !operator.equals("absent")) {
      throw RpcFailure.params(text("wrongOperator", operator));
    }
    RobotSource.NewRobot wanted = source.robot(words(params));
    Optional<Joints> start = start(params);
    DrivenRobot session;
    try {
      session =
          DrivenRobot.begin(
              start.isEmpty()
                  ? wanted
                  : new RobotSource.NewRobot(
                      wanted.options().withStart(start.get()),
                      wanted.waveforms(),
                      wanted.hosts(),
                      wanted.programs()),
              operator.equals("present"),
              params.flag("recording").orElse(true),
              builtins);
    } catch (IllegalArgumentException e) {
      throw RpcFailure.params(e.getMessage());
    }
    created++;
    sessions.put(created, session);
    Map<String, Object> answer = new LinkedHashMap<>();
    answer.put(HANDLE, created);
    answer.put("robot", wanted.options().arm().id());
    answer.put("state", StateRecord.of(session.state(), ""));
    return answer;
  }

  private static Optional<Joints> start(RpcParams params) throws RpcFailure {
    Optional<Json> start = params.get("start");
    if (start.isEmpty()) {
      return Optional.empty();
    }
    if (!(start.get() instanceof Json.Elements array) || array.values().size() != Joints.COUNT) {
      throw RpcParams.wrong("start", start.get(), text("sixAngles"));
    }
    double[] rad = new double[Joints.COUNT];
    for (int i = 0; i < rad.length; i++) {
      rad[i] = RpcParams.number("start[" + i + "]", array.values().get(i), JOINT_RAD);
    }
    return Optional.of(Joints.of(rad));
  }

  /** The parameters as the options of {@code pendant run}, which they are. */
  private static List<String> words(RpcParams params) throws RpcFailure {
    List<String> words = new ArrayList<>();
    for (var each : params.all().entrySet()) {
      if (OWN.contains(each.getKey())) {
        continue;
      }
      String option = "--" + each.getKey().replace('_', '-');
      switch (each.getValue().value()) {
        case Json.Elements list -> {
          for (Json value : list.values()) {
            add(words, option, InputValue.text(each.getKey(), value, Optional.empty()));
          }
        }
        case Json.Members object -> {
          for (var member : object.byKey().entrySet()) {
            String value =
                InputValue.text(member.getKey(), member.getValue().value(), Optional.empty());
            add(words, option, member.getKey() + "=" + value);
          }
        }
        case Json value ->
            add(words, option, InputValue.text(each.getKey(), value, Optional.empty()));
      }
    }
    return words;
  }

  private static void add(List<String> words, String option, String value) {
    words.add(option + "=" + value);
  }

  @Override
  public void close() {
    sessions.values().forEach(DrivenRobot::close);
    sessions.clear();
  }
}
