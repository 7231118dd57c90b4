package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.quantity.Component;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.language.source.ByteText;
import org.pendant.script.value.Value;

/** Methods that read: the state, quantities, variables, the log. */
final class ReadingMethods {
  /** Log lines of an answer at most. */
  private static final int MAX_LINES = 10_000;

  private ReadingMethods() {}

  static void declareIn(MethodTable table) {
    table.add(
        "state", List.of(), (robot, params) -> StateRecord.of(robot.state(), robot.startedFile()));
    table.add("read", List.of("names"), ReadingMethods::read);
    table.add("variables", List.of("names"), ReadingMethods::variables);
    table.add("log", List.of("since"), ReadingMethods::log);
    table.add(
        "quantities",
        params -> {
          params.allow();
          return StateQuantities.all().stream().map(ReadingMethods::described).toList();
        });
  }

  private static Map<String, Object> described(StateQuantity quantity) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("name", quantity.name());
    all.put("group", quantity.group());
    all.put("explanation", quantity.explanation());
    all.put("components", quantity.components().stream().map(Component::name).toList());
    all.put("unit", quantity.components().getFirst().unit().symbol());
    return all;
  }

  private static Object read(DrivenRobot robot, RpcParams params) throws RpcFailure {
    Map<String, Object> values = new LinkedHashMap<>();
    for (String name : params.texts("names").orElseThrow(() -> RpcParams.missing("names"))) {
      values.put(name, QuantityName.of(name).value(robot.state()));
    }
    return values;
  }

  private static Object variables(DrivenRobot robot, RpcParams params) throws RpcFailure {
    SortedMap<String, Value> globals = robot.drive().globals();
    List<String> wanted =
        params.texts("names").orElse(globals.keySet().stream().map(ByteText::decoded).toList());
    ScriptValues values = new ScriptValues();
    Map<String, Object> answer = new LinkedHashMap<>();
    for (String name : wanted) {
      Value value = globals.get(ByteText.asBytes(name));
      if (value == null) {
        throw RpcFailure.params(text("noSuchVariable", name));
      }
      answer.put(name, values.of(value));
    }
    return answer;
  }

  private static Object log(DrivenRobot robot, RpcParams params) throws RpcFailure {
    long since = params.whole("since", 0, Long.MAX_VALUE).orElse(0);
    List<Map<String, Object>> lines = new ArrayList<>();
    for (LogEntry each : robot.robot().logSince(since)) {
      if (lines.size() < MAX_LINES) {
        lines.add(StateRecord.entry(each));
      }
    }
    return lines;
  }
}
