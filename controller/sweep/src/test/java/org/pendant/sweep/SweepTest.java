package org.pendant.sweep;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.sweep.engine.Engine;
import org.pendant.sweep.engine.EngineException;
import org.pendant.sweep.folder.SweepFolder;
import org.pendant.sweep.folder.SweepFolderException;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.run.SweepResult;

final class SweepTest {
  @TempDir private Path folder;
  private Path plan;
  private final List<Long> heard = new ArrayList<>();

  @BeforeEach
  void writePlan() throws IOException {
    plan = folder.resolve("p.toml");
    Files.writeString(folder.resolve("a.script"), "def a():\n  V = 1\n  sleep(V)\nend\n");
    Files.writeString(
        plan,
        """
        program = "a.script"
        arm = "ideal"
        [[parameter]]
        set = "variable V"
        from = 0.1
        to = 0.5
        steps = 5
        """);
  }

  /** Notes what it hears. */
  private final class Ears implements SweepListener {
    @Override
    public void begin(long done, long size) {
      heard.add(done);
      heard.add(size);
    }

    @Override
    public void take(SweepResult result, List<Optional<Object>> row) {
      heard.add((Long) row.getFirst().orElseThrow());
    }
  }

  private long run(Path out, Sweep.Start start, int most)
      throws PlanException, IOException, SweepFolderException, EngineException {
    Sweep sweep = Sweep.read(plan);
    heard.clear();
    try (Engine engine = sweep.local(1)) {
      return sweep.run(out, start, engine, new Ears(), () -> heard.size() >= 2 + most);
    }
  }

  @Test
  void aSweepThatWasStoppedGoesOnAndLeavesTheTableOfOneThatWasNot()
      throws PlanException, IOException, SweepFolderException, EngineException {
    Path out = Sweep.folderOf(plan);
    assertEquals(folder.resolve("p.sweep"), out);
    long done = run(out, Sweep.Start.NEW, 2);
    assertTrue(done >= 2 && done < 5, "done " + done);
    assertEquals(5, run(out, Sweep.Start.RESUME, 100));
    assertEquals(done, heard.getFirst());
    assertEquals(List.of(5L), heard.subList(1, 2));
    assertEquals(5, run(folder.resolve("other"), Sweep.Start.NEW, 100));
    assertEquals(List.of(0L, 5L, 0L, 1L, 2L, 3L, 4L), heard);
    for (String each : List.of(SweepFolder.RESULTS, SweepFolder.PARQUET)) {
      assertArrayEquals(
          Files.readAllBytes(folder.resolve("other").resolve(each)),
          Files.readAllBytes(out.resolve(each)));
    }
  }

  @Test
  void resultsAreOnlyReplacedOnPurpose()
      throws PlanException, IOException, SweepFolderException, EngineException {
    run(Sweep.folderOf(plan), Sweep.Start.NEW, 100);
    assertThrows(SweepFolderException.class, () -> run(Sweep.folderOf(plan), Sweep.Start.NEW, 100));
    Path report = Sweep.folderOf(plan).resolve(SweepFolder.REPORT);
    Files.writeString(report, "of the results before");
    assertEquals(5, run(Sweep.folderOf(plan), Sweep.Start.ANEW, 100));
    assertTrue(Files.notExists(report));
  }

  @Test
  void anyRunOfAFolderIsRecorded()
      throws PlanException, IOException, SweepFolderException, EngineException {
    Path out = Sweep.folderOf(plan);
    run(out, Sweep.Start.NEW, 100);
    Path recording = Sweep.of(out).record(out, 3);
    assertTrue(Files.size(recording) > 100);
    assertThrows(SweepFolderException.class, () -> Sweep.of(out).record(out, 5));
  }

  @Test
  void aSearchForAColumnThatIsNotThereIsRefusedWithThePlan() throws IOException {
    String text = Files.readString(plan);
    Files.writeString(
        plan, text.replace("[[parameter]]", "[search]\nminimize = \"time\"\n[[parameter]]"));
    PlanException wrong = assertThrows(PlanException.class, () -> Sweep.read(plan));
    assertTrue(wrong.getMessage().contains("[search]"), wrong.getMessage());
  }
}
