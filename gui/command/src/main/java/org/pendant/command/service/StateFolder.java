package org.pendant.command.service;

import java.nio.file.Path;
import java.util.Map;

/** State folder: where log files and reports of served controllers are. */
public final class StateFolder {
  private StateFolder() {}

  /**
   * The folder, which may not exist yet: {@code pendant} in the folder for what programs leave
   * behind, else in {@code .local/state} of the home folder.
   *
   * @param environment variables, by name
   */
  public static Path of(Map<String, String> environment) {
    String states = environment.getOrDefault("XDG_STATE_HOME", "");
    Path folder =
        states.isEmpty()
            ? Path.of(System.getProperty("user.home"), ".local", "state")
            : Path.of(states);
    return folder.resolve("pendant");
  }
}
