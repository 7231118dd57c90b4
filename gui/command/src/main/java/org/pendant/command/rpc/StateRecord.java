package org.pendant.command.rpc;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.language.source.ByteText;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ScriptFailure;

/** Snapshots and log lines as values of an answer, under the names of the quantities. */
final class StateRecord {
  /** What every state has; {@code read} tells the others. */
  private static final List<StateQuantity> QUANTITIES =
      Stream.of(
              "target_q",
              "target_qd",
              "actual_q",
              "actual_qd",
              "current",
              "torque",
              "temperature",
              "target_tcp",
              "actual_tcp",
              "tcp_velocity",
              "tcp_speed",
              "tcp_wrench",
              "tcp_force",
              "payload",
              "speed_slider",
              "speed_scaling",
              "encoder_0",
              "encoder_1")
          .map(StateQuantities::of)
          .toList();

  private StateRecord() {}

  /**
   * All of a snapshot.
   *
   * @param file of the program
   */
  static Map<String, Object> of(ControllerState state, String file) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("time_s", state.timeS());
    all.put("frame", state.frame());
    for (StateQuantity each : QUANTITIES) {
      all.put(each.name(), QuantityName.value(each, state));
    }
    all.put("moving", state.arm().moving());
    Map<String, Object> signals = new LinkedHashMap<>();
    for (SignalBank bank : SignalBank.values()) {
      put(signals, bank.text(), state);
    }
    for (AnalogBank bank : AnalogBank.values()) {
      put(signals, bank.text(), state);
    }
    all.put("signals", signals);
    all.put("registers", registers(state));
    all.put("program", program(state.program(), file));
    all.put("safety", safety(state));
    all.put("popups", state.openPopups().stream().map(StateRecord::popup).toList());
    all.put("questions", state.openQuestions().stream().map(StateRecord::question).toList());
    all.put("newest_log", state.newestEntry());
    return all;
  }

  private static void put(Map<String, Object> into, String quantity, ControllerState state) {
    into.put(quantity, QuantityName.value(StateQuantities.of(quantity), state));
  }

  /** Those that are not 0. */
  private static Map<String, Object> registers(ControllerState state) {
    Map<String, Object> registers = new LinkedHashMap<>();
    for (RegisterDirection direction : RegisterDirection.values()) {
      for (RegisterKind kind : RegisterKind.values()) {
        StateQuantity bank = StateQuantities.of(direction.text() + "_" + kind.text() + "_register");
        List<?> values = (List<?>) QuantityName.value(bank, state);
        double[] numbers = bank.numbers(state);
        for (int i = 0; i < numbers.length; i++) {
          if (numbers[i] != 0) {
            registers.put(bank.name() + "[" + i + "]", values.get(i));
          }
        }
      }
    }
    return registers;
  }

  private static Map<String, Object> program(ProgramStatus program, String file) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("state", word(program.state()));
    all.put("name", ByteText.decoded(program.name()));
    all.put("file", file);
    all.put("line", program.line());
    all.put("ending", program.ending().map(ending -> ending(ending, file)));
    return all;
  }

  private static Map<String, Object> ending(Ending ending, String file) {
    return switch (ending) {
      case Ending.Finished _ -> Map.of("kind", "finished");
      case Ending.Halted _ -> Map.of("kind", "halted");
      case Ending.Stopped _ -> Map.of("kind", "stopped");
      case Ending.Failed(ScriptFailure failure) -> {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("kind", "failed");
        all.put("message", ByteText.decoded(failure.message()));
        all.putAll(place(failure, file));
        yield all;
      }
    };
  }

  /** Where a program has failed, and how. */
  static Map<String, Object> place(ScriptFailure failure, String file) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("code", failure.code());
    all.put("file", file);
    all.put("line", failure.line());
    all.put("column", failure.column());
    return all;
  }

  private static Map<String, Object> safety(ControllerState state) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("robot_mode", word(state.safety().robotMode()));
    all.put("safety_mode", word(state.safety().safetyMode()));
    all.put("reduced", state.safety().reduced());
    all.put("stop", state.safety().stop().map(stop -> stop(stop, state)));
    return all;
  }

  private static Map<String, Object> stop(SafetyStop stop, ControllerState state) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("code", stop.codeText());
    all.put("message", stop.message());
    all.put("time_s", stop.timeS());
    all.put("line", state.safety().stopPlace().map(place -> place.line()));
    return all;
  }

  private static Map<String, Object> popup(Popup popup) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("number", popup.number());
    all.put("time_s", popup.timeS());
    all.put("title", ByteText.decoded(popup.title()));
    all.put("text", ByteText.decoded(popup.text()));
    all.put("severity", word(popup.severity()));
    all.put("blocking", popup.blocking());
    return all;
  }

  private static Map<String, Object> question(Question question) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("number", question.number());
    all.put("time_s", question.timeS());
    all.put("kind", word(question.kind()));
    all.put("text", ByteText.decoded(question.text()));
    return all;
  }

  /** A log line. */
  static Map<String, Object> entry(LogEntry entry) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("number", entry.number());
    all.put("time_s", entry.timeS());
    all.put("level", word(entry.level()));
    all.put("origin", word(entry.origin()));
    all.put("code", entry.code());
    all.put("text", ByteText.decoded(entry.text()));
    all.put("source", entry.place().map(place -> ByteText.decoded(place.source())));
    all.put("line", entry.place().map(place -> place.line()));
    return all;
  }

  private static String word(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT);
  }
}
