package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;

/** Signal name: what signals are called on the screen and in scripts. */
final class SignalName {
  private SignalName() {}

  /** As short as on the sockets of a control box, such as {@code DI 0}. */
  static String brief(Signal signal) {
    String letters =
        switch (signal.bank()) {
          case STANDARD_IN -> "DI";
          case STANDARD_OUT -> "DO";
          case CONFIGURABLE_IN -> "CI";
          case CONFIGURABLE_OUT -> "CO";
          case TOOL_IN -> "TI";
          case TOOL_OUT -> "TO";
          case FLAG -> "F";
        };
    return letters + " " + signal.index();
  }

  /** What a group is called. */
  static String of(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN -> text("digitalInputs");
      case STANDARD_OUT -> text("digitalOutputs");
      case CONFIGURABLE_IN -> text("configurableInputs");
      case CONFIGURABLE_OUT -> text("configurableOutputs");
      case TOOL_IN -> text("toolInputs");
      case TOOL_OUT -> text("toolOutputs");
      case FLAG -> text("flags");
    };
  }

  /** The call that reads it in a script, such as {@code get_flag(3)}. */
  static String inScript(Signal signal) {
    String function =
        switch (signal.bank()) {
          case STANDARD_IN -> "get_standard_digital_in";
          case STANDARD_OUT -> "get_standard_digital_out";
          case CONFIGURABLE_IN -> "get_configurable_digital_in";
          case CONFIGURABLE_OUT -> "get_configurable_digital_out";
          case TOOL_IN -> "get_tool_digital_in";
          case TOOL_OUT -> "get_tool_digital_out";
          case FLAG -> "get_flag";
        };
    return function + "(" + signal.index() + ")";
  }

  /** As short as on the sockets of a control box, such as {@code AI 0}. */
  static String brief(AnalogBank bank, int index) {
    String letters =
        switch (bank) {
          case STANDARD_IN -> "AI";
          case STANDARD_OUT -> "AO";
          case TOOL_IN -> "TA";
        };
    return letters + " " + index;
  }

  /** The call that reads it in a script, such as {@code get_standard_analog_in(0)}. */
  static String inScript(AnalogBank bank, int index) {
    String function =
        switch (bank) {
          case STANDARD_IN -> "get_standard_analog_in";
          case STANDARD_OUT -> "get_standard_analog_out";
          case TOOL_IN -> "get_tool_analog_in";
        };
    return function + "(" + index + ")";
  }

  /** A name for components and settings, such as {@code analog-in-0}. */
  static String id(AnalogBank bank, int index) {
    return bank.text().replace('_', '-') + "-" + index;
  }

  /** A name for components and settings, such as {@code input-float-register-3}. */
  static String id(RegisterDirection direction, RegisterKind kind, int address) {
    return direction.text() + "-" + kind.text() + "-register-" + address;
  }

  /** A name for components and settings, such as {@code digital-in-0}. */
  static String id(Signal signal) {
    return signal.bank().text().replace('_', '-') + "-" + signal.index();
  }
}
