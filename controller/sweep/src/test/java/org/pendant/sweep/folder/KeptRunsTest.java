package org.pendant.sweep.folder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.recording.RecordingFile;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.report.SweepReport;
import org.pendant.sweep.run.SweepJob;
import org.pendant.sweep.run.SweepResult;

final class KeptRunsTest {
  @TempDir private Path folder;
  private Path out;
  private SweepJob job;

  @BeforeEach
  void sweep() throws IOException, PlanException, SweepFolderException {
    Path plan = folder.resolve("p.toml");
    Files.writeString(
        folder.resolve("a.script"), "def a():\n  T = 1\n  sleep(T)\n  X = 1 / (T - 0.02)\nend\n");
    Files.writeString(
        plan,
        """
        program = "a.script"
        arm = "ideal"
        [[parameter]]
        name = "T </script>"
        set = "variable T"
        values = [0.01, 0.02, 0.03, 0.02, 0.04, 0.005]
        """);
    job = SweepJob.read(plan);
    out = folder.resolve("out");
    try (SweepFolder results = SweepFolder.create(out, plan, job)) {
      for (long i = 0; i < job.plan().size(); i++) {
        results.add(results.table().row(job.run(job.plan().variant(i))));
      }
    }
  }

  private List<Long> chosen(String wish) throws IOException, SweepFolderException {
    try (ResultReader rows = new ResultReader(out.resolve(SweepFolder.RESULTS))) {
      return List.copyOf(
          new TreeSet<>(
              KeptRuns.parse(wish, org.pendant.sweep.table.ResultTable.of(job.plan()))
                  .choose(rows)));
    }
  }

  @Test
  void firstThatFailedAndLargestNumbersAreChosen() throws IOException, SweepFolderException {
    assertEquals(List.of(1L), chosen("failed=1"));
    assertEquals(List.of(1L, 3L), chosen("failed=20"));
    assertEquals(List.of(2L, 4L), chosen("duration=2"));
    assertEquals(List.of(1L, 4L), chosen("failed=1,duration=1"));
    assertEquals(List.of(0L, 2L), chosen("worst=2"));
  }

  @Test
  void wishThatIsNoneIsRefused() {
    for (String each : List.of("bad=2", "failed", "failed=0", "outcome=2", "worst=1000000", "")) {
      assertThrows(IllegalArgumentException.class, () -> chosen(each), each);
    }
  }

  @Test
  void recordingOfARunIsThatRun() throws IOException, SweepFolderException {
    SweepResult result = job.run(job.plan().variant(4));
    String digest = String.format("%016x", result.digest());
    Path file = KeptRuns.record(out, job, job.plan().variant(4), digest);
    RecordingFile.Opened opened = RecordingFile.open(file);
    assertTrue(opened.warning().isEmpty());
    assertTrue(opened.recording().programs().getFirst().source().text().contains("T = 0.04"));
    assertEquals(file, KeptRuns.record(out, job, job.plan().variant(4), digest));
    SweepFolder.clear(out);
    assertFalse(Files.exists(file));
  }

  @Test
  void runThatComesOutOtherwiseIsNotKept() {
    assertThrows(
        SweepFolderException.class,
        () -> KeptRuns.record(out, job, job.plan().variant(0), "0123456789abcdef"));
    assertFalse(Files.exists(KeptRuns.file(out, 0)));
  }

  @Test
  void reportIsOnePageWithTheRowsAndWithoutAnythingFromElsewhere()
      throws IOException, SweepFolderException {
    String page = SweepReport.of(out);
    assertTrue(page.contains("6 runs: 2 failed, 4 finished."));
    assertTrue(page.contains("\n[0,0.01,\"finished\",\"\","), "row");
    assertEquals(2, page.split("</script>", -1).length - 1);
    assertFalse(page.contains("http://") && !page.contains("http://www.w3.org/2000/svg"));
    assertFalse(page.contains("src="));
    assertFalse(page.contains("@data@"));
    assertThrows(SweepFolderException.class, () -> SweepReport.of(folder));
  }
}
