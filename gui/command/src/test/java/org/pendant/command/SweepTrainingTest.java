package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The sweeps that the launcher has the JVM note the classes of. */
@Tag("slow") // runs sweeps
final class SweepTrainingTest {
  @TempDir Path folder;

  @Test
  void everyProgramIsSweptWhereItLeavesTheOthersAlone() throws IOException {
    String moves =
        Files.writeString(folder.resolve("moves.script"), "movej([0,-1,1,0,0,0])").toString();
    String waits = Files.writeString(folder.resolve("waits.script"), "sleep(0.1)").toString();

    assertEquals(ExitCode.DONE, SweepTraining.run(folder, moves, waits));

    for (String each : new String[] {"0", "1"}) {
      Path results = folder.resolve(each).resolve("plan.sweep/results.csv");
      assertEquals(5, Files.readAllLines(results).size(), "a head and four runs");
    }
  }

  @Test
  void whatDoesNotRunIsTold() throws IOException {
    String wrong = Files.writeString(folder.resolve("wrong.script"), "movej(").toString();

    assertEquals(ExitCode.WRONG_USAGE, SweepTraining.run(folder, wrong));
  }
}
