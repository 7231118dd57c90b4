package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.desktop.session.RecoveryFolder;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.text.ReadProgram;

/**
 * Processes that are killed while the user edits program trees in them; {@code -Dtest.kills=47} or
 * more for a thorough run.
 */
@Tag("slow")
final class KilledWhileEditingTest {
  private static final int KILLS = Integer.getInteger("test.kills", 8);
  private static final int AT_ONCE = 4;
  private static final long SEED = 20_261_122;
  private static final long MAX_MS = 6_500;
  private static final long MAX_LOST_MS = 5_000;
  private static final Pattern STAMP = Pattern.compile("at (\\d{10,})");

  @TempDir Path folder;

  /** The newest edit of each program, by its name, ms since 1970. */
  private record Edits(Map<String, Long> newest) {}

  @Test
  void noFileIsBrokenAndAtMostFiveSecondsAreLost() throws InterruptedException {
    Random random = new Random(SEED);
    List<String> faults = new ArrayList<>();
    try (ExecutorService hands = Executors.newFixedThreadPool(AT_ONCE)) {
      List<Future<List<String>>> kills = new ArrayList<>();
      for (int i = 0; i < KILLS; i++) {
        int number = i;
        long lifeMs = random.nextLong(MAX_MS);
        kills.add(hands.submit(() -> kill(number, lifeMs)));
      }
      for (Future<List<String>> each : kills) {
        faults.addAll(each.get());
      }
    } catch (ExecutionException e) {
      faults.add(e.toString());
    }
    assertEquals(List.of(), faults, "seed " + SEED);
  }

  /**
   * What is wrong after a kill.
   *
   * @param lifeMs how long it is edited before
   */
  private List<String> kill(int number, long lifeMs) throws IOException {
    Path own = Files.createDirectories(folder.resolve("kill" + number));
    Path file = own.resolve("cell.pendant");
    Files.writeString(file, ProgramText.write(ProgramTree.empty()));
    Path kept = own.resolve("recovery");
    List<String> faults = new ArrayList<>();
    Edits edits = edit(file, kept, SEED + number, lifeMs, faults);
    Map<String, Long> found = new HashMap<>();
    look("cell.pendant", Files.readString(file), found, faults);
    List<RecoveryFolder.LeftBehind> left = new RecoveryFolder(kept).leftBehind();
    left.forEach(each -> look(each.name(), each.text(), found, faults));
    if (count(kept) != left.size()) {
      faults.add(count(kept) + " texts were kept, " + left.size() + " can be read");
    }
    edits
        .newest()
        .forEach(
            (name, madeMs) -> {
              long lostMs = madeMs - found.getOrDefault(name, madeMs - lifeMs);
              if (lostMs > MAX_LOST_MS) {
                faults.add(lostMs + " ms of " + name + " are lost");
              }
            });
    return faults.stream().map(fault -> "killed after " + lifeMs + " ms: " + fault).toList();
  }

  private static Edits edit(Path file, Path kept, long seed, long lifeMs, List<String> faults)
      throws IOException {
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-ea",
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-Djava.awt.headless=true",
                "-cp",
                System.getProperty("java.class.path"),
                EditingProcess.class.getName(),
                file.toString(),
                kept.toString(),
                Long.toString(seed))
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    Map<String, Long> newest = new HashMap<>();
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
      long firstMs = 0;
      String line = lines.readLine();
      while (line != null) {
        String[] words = line.split(" ", 2);
        if (words[0].equals("told")) {
          faults.add(words[1]);
        } else {
          long nowMs = Long.parseLong(words[1]);
          firstMs = firstMs == 0 ? nowMs : firstMs;
          newest.put(words[0], nowMs);
          if (nowMs - firstMs >= lifeMs) {
            break;
          }
        }
        line = lines.readLine();
      }
      if (line == null) {
        faults.add("the process ended by itself");
      }
    } finally {
      process.destroyForcibly();
      process.onExit().join();
    }
    return new Edits(newest);
  }

  /** Notes when a text was edited last. */
  private static void look(String name, String text, Map<String, Long> found, List<String> faults) {
    ReadProgram read = ProgramText.read(text);
    if (!read.problems().isEmpty()) {
      faults.add(name + " cannot be read: " + read.problems().getFirst());
    }
    Matcher stamp = STAMP.matcher(text);
    if (stamp.find()) {
      found.merge(name, Long.parseLong(stamp.group(1)), Math::max);
    }
  }

  private static long count(Path kept) throws IOException {
    if (!Files.exists(kept)) {
      return 0;
    }
    try (Stream<Path> files = Files.list(kept)) {
      return files.filter(each -> each.toString().endsWith(".recovery")).count();
    }
  }
}
