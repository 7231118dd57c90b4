package org.pendant.kit.theme;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * System theme: whether it is dark. Java has no way to ask, so each system's own command is run;
 * that takes a while, so not in the dispatch thread.
 */
public final class SystemTheme {
  private static final long PATIENCE_MS = 1_000;

  private SystemTheme() {}

  /** The command that tells it on the system of this name. */
  static List<String> command(String osName) {
    String name = osName.toLowerCase(Locale.ROOT);
    if (name.contains("mac")) {
      return List.of("defaults", "read", "-g", "AppleInterfaceStyle");
    }
    if (name.contains("win")) {
      return List.of(
          "reg",
          "query",
          "HKCU\\Software\\Microsoft\\Windows\\CurrentVersion\\Themes\\Personalize",
          "/v",
          "AppsUseLightTheme");
    }
    return List.of("gsettings", "get", "org.gnome.desktop.interface", "color-scheme");
  }

  /** What the command's output means. */
  static boolean dark(String output) {
    String text = output.toLowerCase(Locale.ROOT);
    return text.contains("dark")
        || text.matches("(?s).*appsuselighttheme\\s+reg_dword\\s+0x0\\b.*");
  }

  /** Asks the system; empty where it does not answer. */
  public static Optional<Boolean> ask() {
    try {
      Process process =
          new ProcessBuilder(command(System.getProperty("os.name")))
              .redirectErrorStream(true)
              .start();
      process.getOutputStream().close();
      if (!process.waitFor(PATIENCE_MS, TimeUnit.MILLISECONDS)) {
        process.destroy();
        return Optional.empty();
      }
      return Optional.of(
          dark(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)));
    } catch (IOException e) {
      // This system has no such command.
      return Optional.empty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }
}
