package org.pendant.command;

import java.nio.file.Path;
import java.util.Optional;
import org.pendant.command.service.DesktopLauncher;
import org.pendant.command.service.DesktopUnavailable;

/**
 * Window training: makes the window and uses it without showing it; the launcher has the JVM note
 * the classes that are loaded for it.
 */
public final class WindowTraining {
  private WindowTraining() {}

  /** Runs the program that {@code words} name in a window. */
  public static void main(String[] words) throws InterruptedException {
    Optional<DesktopLauncher> launcher = DesktopServices.ofClassPath().launcher().get();
    try {
      launcher.orElseThrow().train(Path.of(words[0]).toAbsolutePath());
      System.exit(ExitCode.DONE.number());
    } catch (DesktopUnavailable _) {
      // There may be a display next time: the launcher tries again.
      System.exit(ExitCode.UNAVAILABLE.number());
    }
  }
}
