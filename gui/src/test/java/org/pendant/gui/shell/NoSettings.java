package org.pendant.gui.shell;

import java.util.Optional;
import org.pendant.gui.workbench.Settings;

/** Nothing is remembered. */
final class NoSettings implements Settings {
  @Override
  public Optional<String> get(String name) {
    return Optional.empty();
  }

  @Override
  public void put(String name, String text) {}
}
