package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.desktop.session.RecoveryFolder;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.text.ReadProgram;

/**
 * Windows that are killed at random moments while a user types into the form of a node. The
 * desktop's own tests kill many more processes, without windows.
 */
@Tag("slow")
final class KilledWindowTest {
  private static final int KILLS = Integer.getInteger("test.cases", 1);
  private static final long SEED = 11;
  private static final double MAX_S = 8;
  private static final long MAX_LOST_MS = 5_000;

  @TempDir Path folder;

  private VirtualDisplay display;

  @BeforeEach
  void startDisplay() throws IOException {
    display = VirtualDisplay.start("1440x900");
  }

  @AfterEach
  void stopDisplay() {
    if (display != null) {
      display.close();
    }
  }

  @Test
  void atMostFiveSecondsOfTypingAreLost() throws IOException {
    Random random = new Random(SEED);
    for (int kill = 0; kill < KILLS; kill++) {
      Path own = Files.createDirectories(folder.resolve("kill" + kill));
      double lifeS = 3 + random.nextDouble(MAX_S - 3);
      List<Long> typedMs = typeAndKill(own, lifeS);
      List<RecoveryFolder.LeftBehind> left =
          new RecoveryFolder(own.resolve("pendant/recovery")).leftBehind();
      String what = "killed after " + lifeS + " s";
      assertEquals(1, left.size(), what);
      ReadProgram read = ProgramText.read(left.getFirst().text());
      assertEquals(List.of(), read.problems(), what);
      int kept = Math.min(wholeNumbers(read.tree()), typedMs.size());
      assertTrue(kept > 0, () -> what + ": nothing that was typed is kept");
      long lostMs = typedMs.getLast() - typedMs.get(kept - 1);
      assertTrue(lostMs <= MAX_LOST_MS, what + ": " + lostMs + " ms are lost");
    }
  }

  /** How many numbers the comment has, each with a blank behind it. */
  private static int wholeNumbers(ProgramTree tree) {
    String text =
        tree.nodes().getLast().step() instanceof ActionStep.Comment comment ? comment.text() : "";
    return (int) text.chars().filter(each -> each == ' ').count();
  }

  /** Types numbers from 0; gives back when each was on the screen, ms. */
  private List<Long> typeAndKill(Path own, double lifeS) throws IOException {
    List<Long> typedMs = new ArrayList<>();
    try (OpenWindow window = OpenWindow.open(display, own)) {
      window.click("rail-program");
      window.click("program-empty-file-new");
      window.clickRow("program-palette", "Comment");
      window.click("form-comment-text");
      window.awaitFocus("form-comment-text");
      long startNs = System.nanoTime();
      while (System.nanoTime() - startNs < lifeS * 1e9) {
        String number = typedMs.size() + " ";
        window.type(number);
        // What people have seen on the screen is what they can lose.
        window.awaitWords("form-comment-text", number);
        typedMs.add(System.nanoTime() / 1_000_000);
      }
      window.kill();
    }
    assertFalse(typedMs.isEmpty());
    return typedMs;
  }
}
