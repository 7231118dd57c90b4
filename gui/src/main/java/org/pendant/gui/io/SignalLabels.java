package org.pendant.gui.io;

import org.pendant.controller.io.Signal;
import org.pendant.gui.workbench.Settings;

/** The names that people give to signals and registers, remembered in the settings. */
public final class SignalLabels {
  private final Settings settings;

  /** The names in {@code settings}. */
  public SignalLabels(Settings settings) {
    this.settings = settings;
  }

  /** The name of a digital signal; empty while it has none. */
  public String of(Signal signal) {
    return of(SignalName.id(signal));
  }

  /**
   * The name of a signal or register; empty while it has none.
   *
   * @param id such as {@code digital-in-0}, {@code analog-in-1}, {@code input-float-register-3}
   */
  public String of(String id) {
    return settings.get(key(id)).orElse("");
  }

  /** Names a signal; spaces around the name do not count. */
  void name(String id, String label) {
    if (!label.strip().equals(of(id))) {
      settings.put(key(id), label.strip());
    }
  }

  private static String key(String id) {
    return "io.label." + id;
  }
}
