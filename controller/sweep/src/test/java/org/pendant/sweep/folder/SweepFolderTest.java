package org.pendant.sweep.folder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.run.SweepJob;
import org.pendant.sweep.table.SomeResults;

final class SweepFolderTest {
  @TempDir private Path folder;
  private Path plan;

  @BeforeEach
  void writePlan() throws IOException {
    plan = folder.resolve("p.toml");
    Files.writeString(folder.resolve("a.script"), "def a():\n  V = 1\nend\n");
    Files.writeString(
        plan,
        """
        program = "a.script"
        [sampling]
        method = "random"
        runs = 20
        [[parameter]]
        set = "variable V"
        from = 0
        to = 1
        """);
  }

  private Path out() {
    return folder.resolve("out");
  }

  private SweepJob job() throws PlanException {
    return SweepJob.read(plan);
  }

  private static void add(SweepFolder into, SweepJob job, long from, long to) throws IOException {
    for (long i = from; i < to; i++) {
      into.add(into.table().row(SomeResults.of(job.plan().variant(i))));
    }
  }

  private byte[] whole(SweepJob job) throws IOException, SweepFolderException {
    Path other = folder.resolve("whole");
    try (SweepFolder folderOfAll = SweepFolder.create(other, plan, job)) {
      add(folderOfAll, job, 0, 20);
    }
    return Files.readAllBytes(other.resolve(SweepFolder.RESULTS));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.5, 0.77, 1})
  void tableThatWasCutOffGoesOnAndIsTheUndisturbedOne(double share)
      throws IOException, PlanException, SweepFolderException {
    SweepJob job = job();
    byte[] whole = whole(job);
    try (SweepFolder begun = SweepFolder.create(out(), plan, job)) {
      add(begun, job, 0, 10);
    }
    // the process was killed in the middle of a row, which may be in quotes
    Path results = out().resolve(SweepFolder.RESULTS);
    byte[] written = Files.readAllBytes(results);
    int header = new String(written, java.nio.charset.StandardCharsets.UTF_8).indexOf('\n') + 1;
    int kept = header + (int) (share * (written.length - header));
    Files.write(results, Arrays.copyOf(written, kept));
    try (SweepFolder resumed = SweepFolder.resume(out(), job)) {
      assertEquals(share == 1 ? 10 : Math.floor(share * 10), resumed.next(), 1);
      add(resumed, job, resumed.next(), 20);
    }
    assertTrue(Arrays.equals(whole, Files.readAllBytes(results)));
  }

  @Test
  void resultsAreNotReplacedAndNotMixedWithThoseOfOtherFiles()
      throws IOException, PlanException, SweepFolderException {
    SweepFolder.create(out(), plan, job()).close();
    assertEquals(plan.toAbsolutePath(), SweepFolder.planOf(out()));
    assertThrows(SweepFolderException.class, () -> SweepFolder.create(out(), plan, job()));
    Files.writeString(folder.resolve("a.script"), "def a():\n  V = 2\nend\n");
    assertThrows(SweepFolderException.class, () -> SweepFolder.resume(out(), job()));
    SweepFolder.clear(out());
    SweepFolder.create(out(), plan, job()).close();
  }

  @Test
  void tableWithARowThatIsNoneIsRefused() throws IOException, PlanException, SweepFolderException {
    SweepJob job = job();
    SweepFolder.create(out(), plan, job).close();
    Path results = out().resolve(SweepFolder.RESULTS);
    Files.writeString(results, Files.readString(results) + "7,what\n");
    assertThrows(SweepFolderException.class, () -> SweepFolder.resume(out(), job));
  }
}
