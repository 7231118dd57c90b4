package org.pendant.kit.settings;

import java.nio.file.Path;
import java.util.Map;

/** Configuration folder: where Pendant keeps what belongs to the user. */
public final class ConfigurationFolder {
  /** System property that names another folder, for tests and trials. */
  public static final String PROPERTY = "pendant.config";

  private ConfigurationFolder() {}

  /**
   * The folder, which may not exist yet: that of {@link #PROPERTY}, else {@code pendant} in the
   * folder for configurations, else in {@code .config} of the home folder.
   *
   * @param properties those of the system, by name
   * @param environment variables, by name
   */
  public static Path of(Map<?, ?> properties, Map<String, String> environment) {
    Object chosen = properties.get(PROPERTY);
    if (chosen != null) {
      return Path.of(chosen.toString());
    }
    String configurations = environment.getOrDefault("XDG_CONFIG_HOME", "");
    return configurations.isEmpty()
        ? Path.of(String.valueOf(properties.get("user.home")), ".config", "pendant")
        : Path.of(configurations, "pendant");
  }
}
