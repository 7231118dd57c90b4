package org.pendant.desktop.program;

import java.util.HashMap;
import java.util.Map;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.SignalUse;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.Step;
import org.pendant.project.program.StepNames;

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
    String label = StepNames.label(step, this::signal);
    return ExternalControl.is(step) ? label + ": " + driver.text() : label;
  }

  /** The name of a signal such as {@code digital_out[0]}; itself if it has none. */
  String signal(String signal) {
    return signals.getOrDefault(signal, signal);
  }
}
