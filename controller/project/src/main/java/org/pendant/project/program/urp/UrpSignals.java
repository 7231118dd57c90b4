package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.SignalUse;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;

/** Signal names: what signals are called in PolyScope and in Pendant. */
final class UrpSignals {
  private static final Pattern NUMBERED = Pattern.compile("(\\w+)\\[(\\d{1,3})\\]");

  /** Signals of each kind as files name them, by our names. */
  private static final Map<String, String> THERE =
      Map.of(
          "configurable_in", "config_in",
          "configurable_out", "config_out",
          "input_boolean_register", "GP_bool_in",
          "output_boolean_register", "GP_bool_out",
          "input_integer_register", "GP_int_in",
          "output_integer_register", "GP_int_out",
          "input_float_register", "GP_float_in",
          "output_float_register", "GP_float_out");

  /** How scripts read signals of each kind. */
  private static final Map<String, String> SCRIPT =
      Map.ofEntries(
          Map.entry("digital_in", "get_standard_digital_in"),
          Map.entry("digital_out", "get_standard_digital_out"),
          Map.entry("configurable_in", "get_configurable_digital_in"),
          Map.entry("configurable_out", "get_configurable_digital_out"),
          Map.entry("tool_in", "get_tool_digital_in"),
          Map.entry("tool_out", "get_tool_digital_out"),
          Map.entry("analog_in", "get_standard_analog_in"),
          Map.entry("analog_out", "get_standard_analog_out"),
          Map.entry("tool_analog_in", "get_tool_analog_in"),
          Map.entry("flag", "get_flag"),
          Map.entry("input_boolean_register", "read_input_boolean_register"),
          Map.entry("output_boolean_register", "read_output_boolean_register"),
          Map.entry("input_integer_register", "read_input_integer_register"),
          Map.entry("output_integer_register", "read_output_integer_register"),
          Map.entry("input_float_register", "read_input_float_register"),
          Map.entry("output_float_register", "read_output_float_register"));

  private final Installation installation;
  private final Remarks remarks;

  UrpSignals(Installation installation, Remarks remarks) {
    this.installation = installation;
    this.remarks = remarks;
  }

  /** Our name of the signal that is meant in an element; empty if it names none. */
  String in(XmlElement element) throws UnreadableFile {
    Optional<XmlElement> pin = element.child("pin", "io", "signal");
    return pin.isEmpty() ? "" : named(pin.get());
  }

  /** Our name of the signal that an element is. */
  String named(XmlElement pin) throws UnreadableFile {
    Optional<XmlElement> found = pin.resolved();
    if (found.isEmpty()) {
      remarks.add(pin, text("danglingReference", pin.name()));
      return "";
    }
    String name =
        found.get().attribute("referencedName").or(() -> found.get().attribute("name")).orElse("");
    return here(name)
        .orElseGet(
            () -> {
              remarks.add(pin, text("signalUnknown", name));
              return name;
            });
  }

  private Optional<String> here(String name) {
    Matcher parts = NUMBERED.matcher(name);
    if (parts.matches()) {
      String bank =
          THERE.entrySet().stream()
              .filter(each -> each.getValue().equals(parts.group(1)))
              .map(Map.Entry::getKey)
              .findFirst()
              .orElse(parts.group(1));
      if (SCRIPT.containsKey(bank)) {
        return Optional.of(bank + "[" + parts.group(2) + "]");
      }
    }
    return name.isEmpty()
        ? Optional.of("")
        : installation.signals().stream()
            .filter(each -> each.name().equals(name))
            .map(SignalUse::signal)
            .findFirst()
            .or(
                () ->
                    installation.modbus().stream()
                        .filter(each -> each.name().equals(name))
                        .map(each -> name)
                        .findFirst());
  }

  /** An expression for the present value of a signal with our name. */
  static String expression(String signal) {
    Matcher parts = NUMBERED.matcher(signal);
    if (parts.matches() && SCRIPT.containsKey(parts.group(1))) {
      return SCRIPT.get(parts.group(1)) + "(" + parts.group(2) + ")";
    }
    return "modbus_get_signal_status(\"" + signal + "\")";
  }

  /** What a signal with our name is called in files. */
  static String there(String signal) {
    Matcher parts = NUMBERED.matcher(signal);
    return parts.matches()
        ? THERE.getOrDefault(parts.group(1), parts.group(1)) + "[" + parts.group(2) + "]"
        : signal;
  }
}
