package org.pendant.desktop.program;

import java.util.HashMap;
import java.util.Map;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.SignalUse;
import org.pendant.kit.text.Messages;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.Section;
import org.pendant.project.program.Step;
import org.pendant.project.program.StepNames;
import org.pendant.project.program.TemplateStep;

/**
 * Node labels: what nodes are called on the screen, with what people call things in an
 * installation.
 */
final class NodeLabels {
  /** Where nothing has a name of its own. */
  static final NodeLabels PLAIN = new NodeLabels(Installation.NONE);

  private final Map<String, String> signals = new HashMap<>();
  private final ControlHost driver;

  NodeLabels(Installation installation) {
    driver = installation.controlHost();
    for (SignalUse each : installation.signals()) {
      if (!each.name().isBlank()) {
        signals.put(each.signal(), each.name().strip());
      }
    }
  }

  /** The line for a step. */
  String of(Step step) {
    String label = shown(step, StepNames.label(step, this::signal));
    return ExternalControl.is(step) ? Messages.told(label, driver.text()) : label;
  }

  /** The line for a step with the names that signals have by themselves. */
  static String shown(Step step) {
    return shown(step, StepNames.label(step));
  }

  /** In the language of the window, unless people have written it. */
  private static String shown(Step step, String label) {
    boolean written =
        switch (step) {
          case Section.ThreadSection _, Section.SubProgram _ -> true;
          case MotionStep.Waypoint _ -> true;
          case ActionStep.Comment _, ActionStep.Assignment _, ActionStep.ScriptLine _ -> true;
          case ActionStep.Folder folder -> !folder.name().isBlank();
          default -> false;
        };
    return written ? label : Messages.shown(label, writtenIn(step));
  }

  /** What people have written in the line of a step that says more; empty for nothing. */
  private static String writtenIn(Step step) {
    return switch (step) {
      case ActionStep.Call call -> call.subProgram().strip();
      case ActionStep.Popup popup -> popup.text();
      case ActionStep.ScriptFile file -> file.file().strip();
      case TemplateStep.Palletizing pallet -> pallet.name();
      case TemplateStep.Seek seek -> seek.name();
      case FlowStep.Case each -> each.value().strip();
      default -> "";
    };
  }

  /** The name of a signal such as {@code digital_out[0]}; itself if it has none. */
  String signal(String signal) {
    return signals.getOrDefault(signal, signal);
  }
}
