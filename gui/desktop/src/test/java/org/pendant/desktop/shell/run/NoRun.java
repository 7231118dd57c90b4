package org.pendant.desktop.shell.run;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.session.RunTime;

/** No program has run yet, and none will. */
class NoRun implements RunProgram {
  @Override
  public Optional<String> next() {
    return Optional.empty();
  }

  @Override
  public String name(ControllerState state) {
    return "";
  }

  @Override
  public boolean left(ControllerState state) {
    return false;
  }

  @Override
  public Optional<List<LogEntry>> recordedLog() {
    return Optional.empty();
  }

  @Override
  public Optional<RunNode> nodeAt(int line) {
    return Optional.empty();
  }

  @Override
  public RunTime time() {
    return RunTime.NONE;
  }

  @Override
  public String lineText(int line) {
    return "";
  }

  @Override
  public int shownLine(int line) {
    return line;
  }

  @Override
  public void showLine(int line) {}

  @Override
  public Optional<RunNode> node(ControllerState state) {
    return Optional.empty();
  }

  @Override
  public void show(RunNode node) {}

  @Override
  public OptionalLong turns(ControllerState state) {
    return OptionalLong.empty();
  }

  @Override
  public List<InstallationVariable> installationVariables() {
    return List.of();
  }
}
