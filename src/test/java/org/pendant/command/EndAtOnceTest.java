package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs by a launcher that lets the process end without what the JVM does at an exit. */
@Tag("slow")
final class EndAtOnceTest {
  private static final String AT_ONCE =
      "PENDANT_JAVA_OPTIONS=\"$PENDANT_JAVA_OPTIONS -Dpendant.end-at-once=true\" $PENDANT ";

  @TempDir private Path folder;

  @Test
  void allThatWasSaidAndRecordedIsThere() throws IOException {
    Launcher.script(
        folder,
        "count.script",
        """
        def count():
          i = 0
          while i < 5000:
            textmsg("line ", i)
            i = i + 1
            sync()
          end
        end
        """);

    Launcher.Result result =
        Launcher.shell(folder, AT_ONCE + "run --record out.csv count.script | cat");

    assertEquals("", result.errors());
    assertEquals(5000, result.outputLines().size());
    assertEquals("line 4999", result.outputLines().getLast());
    String record = Files.readString(folder.resolve("out.csv"));
    assertTrue(record.lines().count() > 5000 && record.endsWith("\n"));
  }

  @Test
  void exitCodeTellsHowItEnded() {
    Launcher.script(folder, "stops.script", "def stops():\n  x = 1 / 0\nend\n");

    assertEquals(1, Launcher.shell(folder, AT_ONCE + "run stops.script").exitCode());
    assertEquals(2, Launcher.shell(folder, AT_ONCE + "run missing.script").exitCode());
  }

  @Test
  void interruptedRunHasTheExitCodeOfTheSignal() throws IOException, InterruptedException {
    Launcher.script(
        folder,
        "endless.script",
        "def endless():\n  textmsg(\"started\")\n  while True:\n    sync()\n  end\nend\n");
    ProcessBuilder builder = Launcher.prepare(folder, "run", "--speed", "1", "endless.script");
    builder
        .environment()
        .merge("PENDANT_JAVA_OPTIONS", "-Dpendant.end-at-once=true", (all, one) -> all + " " + one);
    Process process = builder.start();

    try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
      assertEquals("started", output.readLine());
      Process kill = new ProcessBuilder("kill", "-INT", Long.toString(process.pid())).start();
      assertEquals(0, kill.waitFor());
      assertEquals(130, Launcher.await(process));
    }
  }
}
