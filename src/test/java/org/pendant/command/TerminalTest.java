package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;

/** What programs and files say on standard error is shown, never obeyed, by a terminal. */
@Tag("slow")
@DisabledOnOs(OS.WINDOWS)
final class TerminalTest {
  @TempDir Path folder;

  private static void assertOnlyShown(Result result) {
    assertTrue(
        result.errors().chars().noneMatch(c -> c != '\n' && c != '\t' && Character.isISOControl(c)),
        result.errors());
  }

  @Test
  void popupsAreShownAndTextmsgIsRaw() {
    Launcher.script(
        folder,
        "a.script",
        "def a():\n  textmsg(\"\u001b[1m\")\n  popup(\"\u001b]0;x\u0007\")\nend\n");

    Result result = Launcher.pendant(folder, "run", "a.script");

    assertEquals("\u001b[1m\n", result.output());
    assertTrue(result.errors().contains("\\x1b]0;x\\x07"), result.errors());
    assertOnlyShown(result);
  }

  @Test
  void namesAndTextsOfFilesAreShown() {
    Launcher.script(folder, "a\u001b[2Jb\nerror: fake.script", "x = )\u0007\n");
    Launcher.script(folder, "c.pendant", "\u001b]0;owned\u0007\n");

    Result result =
        Launcher.pendant(
            folder,
            "check",
            "a\u001b[2Jb\nerror: fake.script",
            "c.pendant",
            "no\rsuch\u001b.script");
    Result tree = Launcher.pendant(folder, "check", "c.pendant");

    assertOnlyShown(result);
    assertOnlyShown(tree);
    assertFalse(result.errors().lines().anyMatch(line -> line.startsWith("error:")));
    assertEquals("", result.output());
  }
}
