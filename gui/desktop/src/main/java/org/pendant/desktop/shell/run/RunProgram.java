package org.pendant.desktop.shell.run;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.session.RunTime;

/** Run program: what the Run screen asks about the program that runs, or ran last. */
public interface RunProgram {

  /** What the program is called that Run starts; empty while people look at the past. */
  Optional<String> next();

  /** What the program is called that runs in a snapshot, or ran last; empty before the first. */
  String name(ControllerState state);

  /** Whether people have turned to another program since the last one has ended. */
  boolean left(ControllerState state);

  /** The log of the recording that people look at; empty for that of the robot. */
  Optional<List<LogEntry>> recordedLog();

  /** The node where a line of what runs is; empty for scripts. */
  Optional<RunNode> nodeAt(int line);

  /** How long it has run. */
  RunTime time();

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
