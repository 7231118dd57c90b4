package org.pendant.desktop.shell;

import java.util.Optional;
import org.pendant.kit.settings.Settings;

/** Nothing is remembered. */
final class NoSettings implements Settings {
  @Override
  public Optional<String> get(String name) {
    return Optional.empty();
  }

  @Override
  public void put(String name, String text) {}
}
