package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.VariableLiteral;
import org.pendant.controller.message.MessageLog;
import org.pendant.script.value.Value;

/** Installation variables: takes over what a program has left in variables of the installation. */
final class InstalledVariables {
  private InstalledVariables() {}

  /**
   * The variables with the values that a program has left; those that it did not have, or left with
   * something that no program can begin with, stay as they are.
   *
   * @param globals of the program, by name
   * @param log is told of values that cannot be kept
   */
  static List<InstallationVariable> after(
      List<InstallationVariable> variables, Map<String, Value> globals, MessageLog log) {
    List<InstallationVariable> kept = new ArrayList<>(variables.size());
    for (InstallationVariable each : variables) {
      Value left = globals.get(each.name());
      kept.add(left == null ? each : after(each, left, log));
    }
    return kept;
  }

  private static InstallationVariable after(
      InstallationVariable variable, Value left, MessageLog log) {
    Optional<String> literal = VariableLiteral.of(left);
    if (literal.isEmpty()) {
      log.warning(text("variableKept", variable.name(), variable.value()));
      return variable;
    }
    return literal.get().equals(variable.value())
        ? variable
        : new InstallationVariable(variable.name(), literal.get(), variable.favourite());
  }
}
