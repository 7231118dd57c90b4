package org.pendant.command.service;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/**
 * State folder: where log files, reports and noted faults are, at the place that the system has for
 * such files.
 */
public final class StateFolder {
  private StateFolder() {}

  /**
   * The folder of this user, which may not exist yet.
   *
   * @param environment variables, by name
   */
  public static Path of(Map<String, String> environment) {
    return of(System.getProperty("os.name"), System.getProperty("user.home"), environment);
  }

  /**
   * On macOS {@code Library/Logs/Pendant} in the home folder, on Windows {@code Pendant} in that
   * for local data of programs, elsewhere {@code pendant} in what {@code XDG_STATE_HOME} names,
   * without it {@code .local/state} of the home folder.
   */
  static Path of(String system, String home, Map<String, String> environment) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.startsWith("mac")) {
      return Path.of(home, "Library", "Logs", "Pendant");
    }
    if (name.startsWith("windows")) {
      String local = environment.getOrDefault("LOCALAPPDATA", "");
      return (local.isEmpty() ? Path.of(home, "AppData", "Local") : Path.of(local))
          .resolve("Pendant");
    }
    String states = environment.getOrDefault("XDG_STATE_HOME", "");
    return (states.isEmpty() ? Path.of(home, ".local", "state") : Path.of(states))
        .resolve("pendant");
  }

  /**
   * The file in which the window notes faults of its own, which may not exist yet.
   *
   * @param environment variables, by name
   */
  public static Path faults(Map<String, String> environment) {
    return of(environment).resolve("desktop").resolve("errors.txt");
  }
}
