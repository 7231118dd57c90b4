package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;

/** Files that no robot ever saw get an error message, never a stack trace. */
@Tag("slow")
final class HostileInputTest {
  private static final int TEN_MB = 10_000_000;

  @TempDir Path folder;

  private static void assertNoStackTrace(Result result) {
    assertFalse(result.errors().contains("\tat "), result.errors());
    assertFalse(result.errors().contains("internal error"), result.errors());
    assertEquals("", result.output());
  }

  @Test
  void garbageAndNestingAreReportedForEachFile() {
    byte[] garbage = new byte[100_000];
    new Random(1).nextBytes(garbage);
    Launcher.script(folder, "garbage.script", new String(garbage, StandardCharsets.ISO_8859_1));
    Launcher.script(folder, "parentheses.script", "x = " + "(".repeat(10_000));
    Launcher.script(folder, "brackets.script", "x = " + "[".repeat(10_000) + "]".repeat(10_000));
    Launcher.script(folder, "calls.script", "x = " + "abs(".repeat(10_000) + ")".repeat(10_000));
    Launcher.script(folder, "signs.script", "x = " + "-".repeat(10_000) + "1");
    Launcher.script(folder, "nots.script", "x = " + "not ".repeat(10_000) + "True");
    Launcher.script(folder, "ifs.script", "if True:\n".repeat(10_000) + "end\n".repeat(10_000));
    Launcher.script(folder, "defs.script", "def f():\n".repeat(10_000) + "end\n".repeat(10_000));
    Launcher.script(folder, "empty.script", "");
    Launcher.script(folder, "zeros.script", "\0".repeat(1000));

    String[] names = {
      "garbage",
      "parentheses",
      "brackets",
      "calls",
      "signs",
      "nots",
      "ifs",
      "defs",
      "empty",
      "zeros"
    };
    String[] words = new String[names.length + 1];
    words[0] = "run";
    for (int i = 0; i < names.length; i++) {
      words[i + 1] = names[i] + ".script";
    }
    Result result = Launcher.pendant(folder, words);

    assertEquals(3, result.exitCode(), result.errors());
    assertNoStackTrace(result);
    assertAll(
        Stream.of(names)
            .map(name -> () -> assertTrue(result.errors().contains(name + ".script:"), name)));
  }

  @Test
  void longChainsAreNoProblem() {
    // Deep only on the left, as long sums are: these are fine, or refused with a message.
    Launcher.script(folder, "sum.script", "x = 1" + " + 1".repeat(10_000) + "\n");
    Launcher.script(
        folder, "elifs.script", "x = 1\nif x == 0:\n" + "elif x == 2:\n".repeat(10_000) + "end\n");

    Result result = Launcher.pendant(folder, "run", "sum.script", "elifs.script");

    assertNoStackTrace(result);
    assertTrue(result.exitCode() == 0 || result.exitCode() == 3, result.errors());
  }

  @Test
  void filesOfTenMegabytesAreReadOrRefused() {
    Launcher.script(folder, "long_line.script", "x".repeat(TEN_MB));
    Launcher.script(folder, "program.script", "x = 1 + 2 * 3\n".repeat(TEN_MB / 14));
    Launcher.script(folder, "open.script", "x = (1 +\n".repeat(TEN_MB / 9));

    Result result =
        Launcher.pendant(folder, "check", "long_line.script", "program.script", "open.script");

    assertNoStackTrace(result);
    assertEquals(3, result.exitCode());
    // A line of 10 MB is not repeated in the message.
    assertTrue(result.errors().length() < 200_000, "length " + result.errors().length());
  }
}
