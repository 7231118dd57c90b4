package org.pendant.kit.settings;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/** Configuration folder: where Pendant keeps what belongs to the user. */
public final class ConfigurationFolder {
  /** System property that names another folder, for tests and trials. */
  public static final String PROPERTY = "pendant.config";

  private ConfigurationFolder() {}

  /**
   * The folder, which may not exist yet: that of {@link #PROPERTY}, else on macOS {@code
   * Library/Application Support/Pendant} in the home folder, on Windows {@code Pendant} in that for
   * data of programs, elsewhere {@code pendant} in the folder for configurations, without it in
   * {@code .config} of the home folder.
   *
   * @param properties those of the system, by name
   * @param environment variables, by name
   */
  public static Path of(Map<?, ?> properties, Map<String, String> environment) {
    Object chosen = properties.get(PROPERTY);
    if (chosen != null) {
      return Path.of(chosen.toString());
    }
    String system = String.valueOf(properties.get("os.name")).toLowerCase(Locale.ROOT);
    Path home = Path.of(String.valueOf(properties.get("user.home")));
    if (system.startsWith("mac")) {
      return home.resolve(Path.of("Library", "Application Support", "Pendant"));
    }
    if (system.startsWith("windows")) {
      return named(environment, "APPDATA", home.resolve(Path.of("AppData", "Roaming")))
          .resolve("Pendant");
    }
    return named(environment, "XDG_CONFIG_HOME", home.resolve(".config")).resolve("pendant");
  }

  private static Path named(Map<String, String> environment, String variable, Path standard) {
    String name = environment.getOrDefault(variable, "");
    return name.isEmpty() ? standard : Path.of(name);
  }
}
