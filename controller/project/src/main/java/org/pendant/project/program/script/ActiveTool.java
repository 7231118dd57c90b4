package org.pendant.project.program.script;

import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedTool;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ToolChoice;

/** Active tool writer: writes which TCP is active. */
final class ActiveTool {
  private final Installation installation;
  private final ScriptLines lines;

  ActiveTool(ScriptContext context) {
    installation = context.installation();
    lines = context.lines();
  }

  /** Writes what makes the chosen TCP the active one; nothing for whichever is active. */
  void use(ToolChoice choice) {
    pose(choice).ifPresent(this::change);
  }

  /** Writes that a TCP is active from here on. */
  void change(Pose wanted) {
    lines.line("set_tcp(" + ScriptText.pose(wanted) + ")");
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
}
