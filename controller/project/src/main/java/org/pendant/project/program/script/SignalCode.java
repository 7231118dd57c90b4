package org.pendant.project.program.script;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.installation.SignalId;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.SignalBank;

/**
 * Signal code: the calls that read and set a signal, such as {@code digital_out[0]} or one of a
 * device.
 */
final class SignalCode {
  private final Installation installation;

  SignalCode(Installation installation) {
    this.installation = installation;
  }

  /** An expression for its value: a level, V or A, or the value of a register. */
  Optional<String> read(String signal) {
    if (device(signal).isPresent()) {
      return Optional.of("modbus_get_signal_status(" + ScriptText.string(signal) + ")");
    }
    return SignalId.of(signal).map(SignalCode::read);
  }

  private static String read(SignalId signal) {
    return switch (signal) {
      case SignalId.Digital each ->
          "get_" + digital(each.signal().bank()) + "(" + each.signal().index() + ")";
      case SignalId.Analog each -> "get_" + analog(each.bank()) + "(" + each.index() + ")";
      case SignalId.Register each -> {
        String direction = each.direction() == RegisterDirection.INPUT ? "input_" : "output_";
        yield "read_" + direction + each.kind().text() + "_register(" + each.address() + ")";
      }
    };
  }

  /**
   * A statement that sets it; empty if no program can.
   *
   * @param value an expression for a level, V or A, or the value of a register
   */
  Optional<String> write(String signal, String value) {
    Optional<ModbusSetup> device = device(signal);
    if (device.isPresent()) {
      String call =
          device.get().kind().digital()
              ? "modbus_set_output_signal("
              : "modbus_set_output_register(";
      return device
          .filter(each -> each.kind().output())
          .map(_ -> call + ScriptText.string(signal) + ", " + value + ")");
    }
    return SignalId.of(signal).flatMap(each -> write(each, value));
  }

  private Optional<String> write(SignalId signal, String value) {
    return switch (signal) {
      case SignalId.Digital each when !each.signal().bank().input() ->
          Optional.of(
              "set_"
                  + digital(each.signal().bank())
                  + "("
                  + each.signal().index()
                  + ", "
                  + value
                  + ")");
      case SignalId.Analog each when !each.bank().input() ->
          Optional.of(writeAnalog(each.index(), value));
      case SignalId.Register each when each.direction() == RegisterDirection.OUTPUT ->
          Optional.of(
              "write_output_"
                  + each.kind().text()
                  + "_register("
                  + each.address()
                  + ", "
                  + value
                  + ")");
      case SignalId.Digital _, SignalId.Analog _, SignalId.Register _ -> Optional.empty();
    };
  }

  /** Scripts set analog outputs to a part of the range of their domain (manual 18.46). */
  private String writeAnalog(int index, String value) {
    List<AnalogDomain> domains = installation.wiring().analogOut();
    AnalogDomain domain = index < domains.size() ? domains.get(index) : AnalogDomain.CURRENT;
    String above =
        domain.low() == 0 ? "(" + value + ")" : "((" + value + ") - " + domain.low() + ")";
    String part = above + " / " + (domain.high() - domain.low());
    return "set_standard_analog_out(" + index + ", " + part + ")";
  }

  private Optional<ModbusSetup> device(String signal) {
    return installation.modbus().stream().filter(each -> each.name().equals(signal)).findFirst();
  }

  private static String digital(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "standard_digital_in";
      case STANDARD_OUT -> "standard_digital_out";
      case CONFIGURABLE_IN -> "configurable_digital_in";
      case CONFIGURABLE_OUT -> "configurable_digital_out";
      case TOOL_IN -> "tool_digital_in";
      case TOOL_OUT -> "tool_digital_out";
      case FLAG -> "flag";
    };
  }

  private static String analog(AnalogBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "standard_analog_in";
      case STANDARD_OUT -> "standard_analog_out";
      case TOOL_IN -> "tool_analog_in";
    };
  }

  /** Makes a high level of an input do something by itself (manual 19.3, 19.4, 19.12, 19.14). */
  static String action(SignalId input, String action) {
    String name = ScriptText.string(action);
    return switch (input) {
      case SignalId.Digital each ->
          "set_"
              + digital(each.signal().bank()).replace("_in", "_input")
              + "_action("
              + each.signal().index()
              + ", "
              + name
              + ")";
      case SignalId.Register each ->
          "set_gp_boolean_input_action(" + each.address() + ", " + name + ")";
      case SignalId.Analog _ -> throw new IllegalArgumentException("an analog input does nothing");
    };
  }

  /** Makes an output follow what programs do (manual 19.6 to 19.10). */
  static String runState(SignalId output, int action) {
    String start = "set_runstate_";
    return switch (output) {
      case SignalId.Digital each ->
          start
              + digital(each.signal().bank())
              + "put_to_value("
              + each.signal().index()
              + ", "
              + action
              + ")";
      case SignalId.Register each ->
          start + "gp_boolean_output_to_value(" + each.address() + ", " + action + ")";
      case SignalId.Analog each ->
          start + "standard_analog_output_to_value(" + each.index() + ", " + action + ")";
    };
  }
}
