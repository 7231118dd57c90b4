package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.json.Range;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.Recording;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableTracer;

/** Methods about what is recorded: {@code recording}, and {@code trace} for variables. */
final class RecordingMethods {
  /** Numbers of an answer at most; where the next row would be says that there are more. */
  static final int MAX_NUMBERS = 500_000;

  private static final double FRAMES_PER_SECOND = FrameTime.FRAMES_PER_SECOND;
  private static final String OWNER = "rpc";
  private static final String VARIABLE = "var:";
  private static final Range SECONDS = new Range(0, 1e9, "s");
  private static final int MAX_EVERY = 1_000_000;

  private RecordingMethods() {}

  static void declareIn(MethodTable table) {
    table.add("trace", List.of("variables"), RecordingMethods::trace);
    table.add("recording", List.of("from", "to", "columns", "every"), RecordingMethods::recording);
  }

  /** What a column is made of. */
  private record Column(String name, Function<ControllerState, Object> value, int numbers) {
    static Column of(String name) throws RpcFailure {
      if (name.startsWith(VARIABLE)) {
        String variable = name.substring(VARIABLE.length());
        return new Column(
            name,
            state -> state.traced().has(variable) ? state.traced().value(variable) : Double.NaN,
            1);
      }
      QuantityName quantity = QuantityName.of(name);
      return new Column(name, quantity::value, quantity.size());
    }
  }

  private static Object trace(DrivenRobot robot, RpcParams params) throws RpcFailure {
    List<VariablePath> paths = new ArrayList<>();
    for (String each :
        params.texts("variables").orElseThrow(() -> RpcParams.missing("variables"))) {
      try {
        paths.add(VariablePath.of(each));
      } catch (IllegalArgumentException e) {
        throw RpcFailure.params(each + ": " + e.getMessage());
      }
    }
    if (paths.size() > VariableTracer.MOST) {
      throw RpcFailure.params(text("tooManyVariables", VariableTracer.MOST));
    }
    robot.ask(new DebugCommand.TraceVariables(OWNER, paths));
    return Map.of();
  }

  private static Object recording(DrivenRobot robot, RpcParams params) throws RpcFailure {
    Recording recording =
        robot
            .recording()
            .orElseThrow(() -> new RpcFailure(RpcFailure.REFUSED, text("withoutRecording")));
    List<Column> columns = new ArrayList<>();
    for (String each : params.texts("columns").orElseThrow(() -> RpcParams.missing("columns"))) {
      columns.add(Column.of(each));
    }
    OptionalDouble from = params.number("from", SECONDS);
    OptionalDouble to = params.number("to", SECONDS);
    long first = from.isPresent() ? recording.frameAt(from.getAsDouble()) : recording.firstFrame();
    long last = to.isPresent() ? recording.frameAt(to.getAsDouble()) : recording.lastFrame();
    long every = params.whole("every", 1, MAX_EVERY).orElse(1);
    long rows = last < first ? 0 : (last - first) / every + 1;
    long numbers = 1 + columns.stream().mapToLong(Column::numbers).sum();
    return table(
        recording, first, every, Math.min(rows, Math.max(1, MAX_NUMBERS / numbers)), rows, columns);
  }

  private static Map<String, Object> table(
      Recording recording, long first, long every, long rows, long all, List<Column> columns) {
    List<Object> times = new ArrayList<>();
    Map<String, List<Object>> cells = new LinkedHashMap<>();
    columns.forEach(each -> cells.put(each.name(), new ArrayList<>()));
    Consumer<ControllerState> row =
        state -> columns.forEach(each -> cells.get(each.name()).add(each.value().apply(state)));
    new Rows(recording, first, every, rows).forEach(row);
    for (long i = 0; i < rows; i++) {
      times.add((first + i * every) / FRAMES_PER_SECOND);
    }
    Map<String, Object> answer = new LinkedHashMap<>();
    answer.put("first_frame", recording.firstFrame());
    answer.put("last_frame", recording.lastFrame());
    answer.put(
        "next_s",
        rows < all ? Optional.of((first + rows * every) / FRAMES_PER_SECOND) : Optional.empty());
    answer.put("time_s", times);
    answer.put("columns", cells);
    return answer;
  }

  /** Snapshots of a recording, one for each row. */
  private record Rows(Recording recording, long first, long every, long count) {
    /** Goes through it once; a frame in which nothing changed is looked up by itself. */
    void forEach(Consumer<ControllerState> reader) {
      long[] next = {first};
      long end = first + count * every;
      if (count > 0) {
        recording.frames(
            first,
            end - every,
            state -> {
              fill(next, Math.min(state.frame(), end), reader);
              if (state.frame() == next[0] && next[0] < end) {
                reader.accept(state);
                next[0] += every;
              }
            });
        fill(next, end, reader);
      }
    }

    private void fill(long[] next, long before, Consumer<ControllerState> reader) {
      for (; next[0] < before; next[0] += every) {
        reader.accept(recording.atFrame(next[0]));
      }
    }
  }
}
