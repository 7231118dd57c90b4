package org.pendant.gui.io;

import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;

/** What signals are called on the screen and in scripts. */
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
      case STANDARD_IN -> "Digital inputs";
      case STANDARD_OUT -> "Digital outputs";
      case CONFIGURABLE_IN -> "Configurable inputs";
      case CONFIGURABLE_OUT -> "Configurable outputs";
      case TOOL_IN -> "Tool inputs";
      case TOOL_OUT -> "Tool outputs";
      case FLAG -> "Flags";
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

  /** A name for components and settings, such as {@code digital-in-0}. */
  static String id(Signal signal) {
    return signal.bank().text().replace('_', '-') + "-" + signal.index();
  }
}
