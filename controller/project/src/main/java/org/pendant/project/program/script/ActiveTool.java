package org.pendant.project.program.script;

import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedTool;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ToolChoice;

/** Which TCP is active at the place of the script that is being written, as far as that is sure. */
final class ActiveTool {
  private final Installation installation;
  private final ScriptLines lines;
  private final boolean everChanges;
  private Optional<Pose> known;

  ActiveTool(ScriptContext context) {
    installation = context.installation();
    lines = context.lines();
    Pose first = installation.activeToolInFlange();
    known = Optional.of(first);
    everChanges =
        context.survey().setsTool()
            || context.survey().tools().stream()
                .anyMatch(each -> pose(each).filter(pose -> !pose.equals(first)).isPresent());
  }

  /** Writes what makes the chosen TCP the active one, if it may be another one. */
  void use(ToolChoice choice) {
    pose(choice).ifPresent(this::set);
  }

  private void set(Pose wanted) {
    if (known.isEmpty() || !known.get().equals(wanted)) {
      change(wanted);
    }
  }

  /** Writes that a TCP is active from here on. */
  void change(Pose wanted) {
    lines.line("set_tcp(" + ScriptText.pose(wanted) + ")");
    known = Optional.of(wanted);
  }

  /**
   * The TCP of a choice, in the flange frame; empty for whichever is active, and for unknown ones.
   */
  Optional<Pose> pose(ToolChoice choice) {
    return switch (choice) {
      case ToolChoice.Active _ -> Optional.empty();
      case ToolChoice.Flange _ -> Optional.of(Pose.ZERO);
      case ToolChoice.Named named -> installation.tool(named.name()).map(NamedTool::inFlange);
    };
  }

  /** From here on it depends on the way that the program has come. */
  void forget() {
    if (everChanges) {
      known = Optional.empty();
    }
  }
}
