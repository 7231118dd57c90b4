package org.pendant.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.pendant.command.Launcher;
import org.pendant.command.ProductJvm;

/**
 * AOT training: runs that record the classes which the JVMs that tests start load, for their AOT
 * caches.
 */
final class AotTraining {
  private AotTraining() {}

  public static void main(String[] arguments) throws IOException {
    if (!ProductJvm.COMMAND.isFresh()) {
      makeJarsStartable();
    }
    Optional<Process> command =
        ProductJvm.COMMAND.isFresh() ? Optional.empty() : Optional.of(startCommand());
    if (VirtualDisplay.isAvailable() && !ProductJvm.WINDOW.isFresh()) {
      useWindow();
    }
    command.ifPresent(Launcher::await);
  }

  /** As the launcher does with the jars that it starts. */
  private static void makeJarsStartable() throws IOException {
    ProductJvm.copyJars();
    Process rewriting =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                Launcher.home().resolve(".build/StartableJars.java").toString(),
                ProductJvm.folder().toString())
            .inheritIO()
            .start();
    if (Launcher.await(rewriting) != 0) {
      throw new IOException("the jars cannot be made startable");
    }
  }

  /** Runs small programs. */
  private static Process startCommand() throws IOException {
    Files.deleteIfExists(ProductJvm.COMMAND.cache());
    ProcessBuilder command =
        Launcher.prepare(
            Launcher.home(),
            "run",
            "examples/hello.script",
            "examples/pick_and_place.script",
            "examples/shared_counter.script",
            "examples/statistics.script");
    command.environment().put("PENDANT_CLASSPATH", ProductJvm.startableJars());
    command
        .environment()
        .put("PENDANT_JAVA_OPTIONS", String.join(" ", ProductJvm.COMMAND.trainingOptions()));
    // The JVM that writes the cache says there with which options, a page of them.
    return command
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start();
  }

  /** Opens the desktop, shows its screens and runs a program. */
  private static void useWindow() throws IOException {
    Path cache = ProductJvm.WINDOW.cache();
    Files.deleteIfExists(cache);
    Path folder = Files.createDirectories(cache.resolveSibling("training"));
    try (VirtualDisplay display = VirtualDisplay.start("1440x900");
        OpenWindow window = OpenWindow.openAndTrain(display, folder)) {
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
