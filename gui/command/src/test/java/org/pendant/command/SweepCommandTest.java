package org.pendant.command;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code pendant sweep}, from the plan to the table. */
final class SweepCommandTest {
  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @BeforeEach
  void writeFiles() throws IOException {
    Files.writeString(
        folder.resolve("wait.script"),
        """
        def waits():
          T = 0.1
          sleep(T)
          done = 1 / (T - 0.2)
        end
        """);
    Files.writeString(
        folder.resolve("wait.toml"),
        """
        program = "wait.script"
        arm = "ideal"
        variables = ["done"]
        [[parameter]]
        name = "T"
        set = "variable T"
        values = [0.01, 0.02, 0.1, 0.2, 0.04]
        """);
  }

  private ExitCode sweep(Object... words) {
    List<String> line = new ArrayList<>(List.of("sweep"));
    Arrays.stream(words).map(Object::toString).forEach(line::add);
    output.reset();
    errors.reset();
    return new Pendant(new Console(output, errors)).run(line);
  }

  private Path plan() {
    return folder.resolve("wait.toml");
  }

  private Path results() {
    return folder.resolve("wait.sweep/results.csv");
  }

  @Test
  void everyVariantHasARowAndStandardOutputHasTheSummary() throws IOException {
    assertEquals(ExitCode.DONE, sweep(plan()), errors.toString(UTF_8));
    List<String> rows = Files.readAllLines(results());
    assertEquals(6, rows.size());
    assertTrue(rows.get(1).startsWith("0,0.01,finished,,"), rows.get(1));
    assertTrue(rows.get(4).startsWith("3,0.2,failed,"), rows.get(4));
    List<String> lines = output.toString(UTF_8).lines().toList();
    assertEquals(
        List.of("outcome   runs", "failed       1", "finished     4"), lines.subList(0, 3));
    assertEquals("results: " + results(), lines.getLast());
    assertTrue(errors.toString(UTF_8).contains("5 of 5 runs"), errors.toString(UTF_8));
  }

  @Test
  void tableIsTheSameToTheByteWhateverTheWorkers() throws IOException {
    sweep("--workers", "1", plan());
    byte[] one = Files.readAllBytes(results());
    sweep("--workers", "3", "--force", plan());
    assertArrayEquals(one, Files.readAllBytes(results()));
  }

  @Test
  void sweepGoesOnBehindTheLastWholeRow() throws IOException {
    sweep(plan());
    byte[] whole = Files.readAllBytes(results());
    Files.write(results(), Arrays.copyOf(whole, whole.length / 2));
    assertEquals(ExitCode.WRONG_USAGE, sweep(plan()));
    assertTrue(errors.toString(UTF_8).contains("--resume goes on with them"));
    assertEquals(ExitCode.DONE, sweep("--resume", plan()));
    assertArrayEquals(whole, Files.readAllBytes(results()));
    Files.writeString(folder.resolve("wait.script"), "def other():\n  T = 1\nend\n");
    assertEquals(ExitCode.WRONG_USAGE, sweep("--resume", plan()));
  }

  @Test
  void conditionThatDoesNotHoldIsTheExitCode() {
    assertEquals(ExitCode.DONE, sweep("--assert", "duration < 1", plan()));
    assertEquals(
        ExitCode.LIMIT_EXCEEDED,
        sweep("--force", "--assert", "outcome == finished", "--assert", "duration < 0.05", plan()));
    String told = errors.toString(UTF_8);
    assertTrue(told.contains("outcome == finished does not hold for 1 run: run 3 (failed)"), told);
    assertTrue(told.contains("duration < 0.05 does not hold for 2 runs: run 2 ("), told);
  }

  @Test
  void whatIsWrongIsToldBeforeAnythingRuns() throws IOException {
    assertEquals(ExitCode.WRONG_USAGE, sweep("--assert", "duraton < 1", plan()));
    assertTrue(errors.toString(UTF_8).contains("did you mean duration?"));
    Files.writeString(plan(), "program = \"wait.script\"\nsamplin = 3\n");
    assertEquals(ExitCode.WRONG_USAGE, sweep(plan()));
    assertTrue(
        errors
            .toString(UTF_8)
            .startsWith(plan() + ":2:1: error: there is no samplin in the plan, did you mean"),
        errors.toString(UTF_8));
    Files.writeString(folder.resolve("wait.script"), "def waits(:\nend\n");
    Files.writeString(
        plan(), "program = \"wait.script\"\n[[parameter]]\nset = \"seed\"\nvalues = [1]\n");
    assertEquals(ExitCode.WRONG_USAGE, sweep(plan()));
    assertTrue(errors.toString(UTF_8).startsWith("wait.script:1:11: error: "));
    assertEquals(ExitCode.WRONG_USAGE, sweep(folder.resolve("nothing.toml")));
    assertEquals(ExitCode.WRONG_USAGE, sweep());
    assertTrue(Files.notExists(results()));
  }

  @Test
  void anyRunOfTheTableIsRecordedAndTheReportIsOnePage() throws IOException {
    assertEquals(ExitCode.DONE, sweep("--keep", "failed=1", plan()));
    Path kept = folder.resolve("wait.sweep/kept");
    assertTrue(output.toString(UTF_8).contains("pendant open " + kept.resolve("3.rec")));
    assertEquals(ExitCode.DONE, sweep("record", folder.resolve("wait.sweep"), 1, 4));
    assertEquals(
        "pendant open " + kept.resolve("1.rec") + "\npendant open " + kept.resolve("4.rec") + "\n",
        output.toString(UTF_8));
    assertTrue(Files.size(kept.resolve("4.rec")) > 100);
    assertEquals(ExitCode.DONE, sweep("report", folder.resolve("wait.sweep")));
    assertTrue(Files.readString(folder.resolve("wait.sweep/report.html")).contains("5 runs"));
    assertTrue(Files.size(folder.resolve("wait.sweep/results.parquet")) > 100);
    assertEquals(ExitCode.WRONG_USAGE, sweep("record", folder.resolve("wait.sweep"), 5));
    assertTrue(errors.toString(UTF_8).contains("has no row of run 5"), errors.toString(UTF_8));
    assertEquals(ExitCode.WRONG_USAGE, sweep("record", folder.resolve("wait.sweep"), "x"));
    assertEquals(ExitCode.WRONG_USAGE, sweep("report", folder));
    assertEquals(ExitCode.WRONG_USAGE, sweep("--keep", "fialed=1", "--force", plan()));
    assertTrue(errors.toString(UTF_8).contains("did you mean failed?"), errors.toString(UTF_8));
  }

  @Test
  void searchFindsTheBestAndItsRunsAreRecorded() throws IOException {
    Files.writeString(
        plan(),
        """
        program = "wait.script"
        arm = "ideal"
        [search]
        minimize = "duration"
        limits = ["duration >= 0.1"]
        runs = 40
        [[parameter]]
        name = "T"
        set = "variable T"
        from = 0
        to = 0.19
        """);
    assertEquals(ExitCode.DONE, sweep(plan()), errors.toString(UTF_8));
    String last = output.toString(UTF_8).lines().toList().getLast();
    assertTrue(
        last.matches(
            "best: run \\d+, duration 0\\.10\\d*, with T = 0\\.09\\d+|best: run .*0\\.1.*"),
        last);
    byte[] whole = Files.readAllBytes(results());
    Files.write(results(), Arrays.copyOf(whole, whole.length / 2));
    assertEquals(ExitCode.DONE, sweep("--resume", "--workers", "1", plan()));
    assertArrayEquals(whole, Files.readAllBytes(results()));
    assertEquals(ExitCode.DONE, sweep("record", folder.resolve("wait.sweep"), 23));
  }

  @Test
  void optionsOfOneEngineAreRefusedWithTheOther() {
    assertEquals(ExitCode.WRONG_USAGE, sweep("--master", "yarn", plan()));
    assertTrue(errors.toString(UTF_8).contains("--master goes with --engine spark"));
    assertEquals(ExitCode.WRONG_USAGE, sweep("--engine", "spark", "--workers", "3", plan()));
    assertTrue(errors.toString(UTF_8).contains("--workers is of --engine local"));
    assertEquals(ExitCode.WRONG_USAGE, sweep("--engine", "flink", plan()));
    assertTrue(errors.toString(UTF_8).contains("--engine is flink, must be local or spark"));
  }

  @Test
  void planThatOtherComputersCannotReadIsRefusedBeforeSparkIsStarted() throws IOException {
    Path plan = plan();
    String program = folder.resolve("wait.script").toString();
    Files.writeString(plan, Files.readString(plan).replace("\"wait.script\"", "'" + program + "'"));

    assertEquals(ExitCode.WRONG_USAGE, sweep("--engine", "spark", plan));

    String told = errors.toString(UTF_8);
    assertTrue(told.contains(program + ": the plan names a file by its whole path"), told);
  }
}
