package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Signals while a run cannot come to its end. */
@Tag("slow")
final class SecondSignalTest {
  private static final int SIGTERM = 15;

  @TempDir Path folder;

  @Test
  void anotherSignalEndsARunWhoseOutputNobodyReads() throws IOException, InterruptedException {
    Launcher.script(
        folder,
        "talks.script",
        """
        def talks():
          while True:
            textmsg("a line that fills the pipe, as nobody reads more than its first byte")
            sync()
          end
        end
        """);
    Process process = Launcher.start(folder, "run", "talks.script");
    assertEquals('a', process.getInputStream().read());
    do {
      Process kill =
          new ProcessBuilder("kill", "-TERM", Long.toString(process.pid()))
              .redirectErrorStream(true)
              .start();
      kill.waitFor();
    } while (!process.waitFor(50, TimeUnit.MILLISECONDS));
    assertEquals(128 + SIGTERM, process.exitValue());
    String errors = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
    assertFalse(errors.contains("did not end"), errors);
  }
}
