package org.pendant.desktop.shell.run;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.program.RunNode;

/** Run program: what the Run screen asks about the program that was started last. */
public interface RunProgram {

  /** What it is called; empty for as the program that is open. */
  default Optional<String> name() {
    return Optional.empty();
  }

  /** Text of a line of what runs. */
  String lineText(int line);

  /** The line that people see for a line of what runs. */
  int shownLine(int line);

  /** Shows a line of what runs. */
  void showLine(int line);

  /** The node where a tree is; empty for scripts and while nothing runs. */
  Optional<RunNode> node(ControllerState state);

  /** Shows a node. */
  void show(RunNode node);

  /** How many turns of the main program have begun; empty where they cannot be counted. */
  OptionalLong turns(ControllerState state);

  /** The variables that every program has. */
  List<InstallationVariable> installationVariables();
}
