package org.pendant.window;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;

/**
 * A display in memory, an Xvfb. Tests never use the display of the user who runs them: they would
 * take the mouse away, and a touch of it would fail them.
 *
 * @param name for the environment variable DISPLAY
 */
record VirtualDisplay(String name, Process server) implements AutoCloseable {

  /** Starts one of {@code size} pixels, such as {@code 1440x900}; skips the test without Xvfb. */
  static VirtualDisplay start(String size) throws IOException {
    Optional<Path> program = program();
    assumeTrue(program.isPresent(), "there is no Xvfb on PATH to open a window on");
    Process server =
        new ProcessBuilder(
                program.get().toString(),
                "-displayfd",
                "1",
                "-screen",
                "0",
                size + "x24",
                "-nolisten",
                "tcp",
                // Or it begins anew when its last window has gone, while the next is on its way.
                "-noreset")
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    // It writes its number when it can be used.
    BufferedReader out =
        new BufferedReader(
            new InputStreamReader(server.getInputStream(), StandardCharsets.US_ASCII));
    String number = out.readLine();
    if (number == null) {
      throw new IOException("Xvfb ended with exit code " + server.onExit().join().exitValue());
    }
    return new VirtualDisplay(":" + number, server);
  }

  /** Whether there is an Xvfb on PATH. */
  static boolean isAvailable() {
    return program().isPresent();
  }

  private static Optional<Path> program() {
    return Arrays.stream(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator))
        .map(folder -> Path.of(folder, "Xvfb"))
        .filter(Files::isExecutable)
        .findFirst();
  }

  @Override
  public void close() {
    server.destroy();
    server.onExit().join();
  }
}
