package org.pendant.gui.io;

import org.pendant.controller.io.Signal;
import org.pendant.gui.workbench.Settings;

/** The names that people give to signals, remembered in the settings. */
final class SignalLabels {
  private final Settings settings;

  SignalLabels(Settings settings) {
    this.settings = settings;
  }

  /** The name of a signal; empty while it has none. */
  String of(Signal signal) {
    return settings.get(key(signal)).orElse("");
  }

  /** Names a signal; spaces around the name do not count. */
  void name(Signal signal, String label) {
    if (!label.strip().equals(of(signal))) {
      settings.put(key(signal), label.strip());
    }
  }

  private static String key(Signal signal) {
    return "io.label." + SignalName.id(signal);
  }
}
