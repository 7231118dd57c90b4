package org.pendant.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.pendant.command.ProductJvm;

/**
 * Records the classes that a desktop loads while it opens, shows its screens and runs a program,
 * for the AOT cache of the JVMs that tests start. Arguments: the cache, the jar of the test
 * classes.
 */
final class AotTraining {
  private AotTraining() {}

  public static void main(String[] arguments) throws IOException {
    Path cache = Path.of(arguments[0]);
    String classPath = ProductJvm.jars(Path.of(arguments[1]));
    if (!VirtualDisplay.isAvailable() || ProductJvm.isFresh(cache, classPath)) {
      return;
    }
    Files.deleteIfExists(cache);
    Path folder = Files.createDirectories(cache.resolveSibling("training"));
    try (VirtualDisplay display = VirtualDisplay.start("1440x900");
        OpenWindow window = OpenWindow.openAndTrain(display, folder, classPath, cache)) {
      window.awaitWords("robot-mode", "running");
      for (String screen : new String[] {"program", "script", "move", "log", "run"}) {
        window.click("rail-" + screen);
      }
      window.press("F5");
      window.awaitWords("program-state", "running");
      window.press("shift F5");
      window.askToClose();
      window.awaitEnd();
    }
  }
}
