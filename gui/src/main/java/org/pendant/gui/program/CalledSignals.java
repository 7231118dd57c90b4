package org.pendant.gui.program;

import java.util.HashMap;
import java.util.Map;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.SignalUse;

/** What people call the signals of an installation. */
final class CalledSignals {
  private final Map<String, String> names = new HashMap<>();

  CalledSignals(Installation installation) {
    for (SignalUse each : installation.signals()) {
      if (!each.name().isBlank()) {
        names.put(each.signal(), each.name().strip());
      }
    }
  }

  /** The name of a signal such as {@code digital_out[0]}; itself if it has none. */
  String of(String signal) {
    return names.getOrDefault(signal, signal);
  }
}
