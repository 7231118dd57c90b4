package org.pendant.sweep.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.sweep.plan.PlanException;

/** What the parameters of a plan change, and what is told of a run. */
final class SweepJobTest {
  private static final String PROGRAM =
      """
      def work():
        FAST = 0.5
        place = p[0.4, -0.2, 0.3, 0, 3.1416, 0]
        def go(target, blend=0):
          movel(target, a=1.2, v=FAST, r=blend)
        end
        movej([0.8, -1.2, -1.8, -1.57, 1.57, 0], a=3, v=2)
        go(place)
        set_standard_digital_out(1, True)
        global reached = get_actual_tcp_pose()
      end
      """;

  @TempDir private Path folder;

  private SweepJob job(String program, String plan) throws IOException, PlanException {
    Files.writeString(folder.resolve("work.script"), program);
    Files.writeString(
        folder.resolve("p.toml"), "program = \"work.script\"\narm = \"ideal\"\n" + plan);
    return SweepJob.read(folder.resolve("p.toml"));
  }

  private SweepResult run(String plan, long number) throws IOException, PlanException {
    SweepJob job = job(PROGRAM, plan);
    return job.run(job.plan().variant(number));
  }

  private static String values(String set, String values) {
    return "[[parameter]]\nset = \"" + set + "\"\nvalues = [" + values + "]\n";
  }

  @Test
  void sameVariantGivesTheSameResultToTheLastBit() throws IOException, PlanException {
    SweepJob job = job(PROGRAM, values("variable FAST", "0.3, 0.6"));
    SweepResult slow = job.run(job.plan().variant(0));
    SweepResult fast = job.run(job.plan().variant(1));
    assertEquals(RunOutcome.FINISHED, slow.outcome());
    assertEquals(slow, job.run(job.plan().variant(0)));
    assertNotEquals(slow.digest(), fast.digest());
    assertTrue(fast.durationS() < slow.durationS(), fast.durationS() + " s");
  }

  @Test
  void resultTellsLinesOutputsAndVariables() throws IOException, PlanException {
    SweepResult result = run("variables = [\"FAST\", \"nothing\"]\n" + values("seed", "1"), 0);
    assertEquals(List.of("0.5", ""), result.variables());
    assertEquals("digital_out[1]", result.outputs().getFirst().signal());
    assertTrue(result.outputs().getFirst().level());
    long frames = result.lines().stream().mapToLong(LineTime::frames).sum();
    assertEquals(result.durationS(), frames * 0.002, 0.01);
    assertTrue(result.lines().stream().anyMatch(each -> each.line() == 5));
    assertEquals(0.4, result.endTcpInBase().get(0), 1e-6);
  }

  @Test
  void linesOfATreeBelongToItsNodes() throws IOException, PlanException {
    String tree =
        """
        pendant program 1
        main
          comment text="first"
          script-line code="sleep(0.1)"
          script-line code="halt"
        """;
    Files.writeString(folder.resolve("nap.pendant"), tree);
    Path plan =
        Files.writeString(
            folder.resolve("p.toml"), "program = \"nap.pendant\"\n" + values("seed", "1"));
    SweepJob job = SweepJob.read(plan);
    int ended = job.run(job.plan().variant(0)).line();
    ProgramNodes nodes = job.nodes().orElseThrow();
    assertTrue(ended > 5, "the script has more lines than the tree: " + ended);
    assertEquals(new ProgramNodes.Place(3, "sleep(0.1)"), nodes.at(ended).orElseThrow());
    assertTrue(job(PROGRAM, values("seed", "1")).nodes().isEmpty());
  }

  @Test
  void elementOfAPoseAndTheWholeOfItAreSet() throws IOException, PlanException {
    assertEquals(-0.1, run(values("variable place[1]", "-0.1"), 0).endTcpInBase().get(1), 1e-6);
    assertEquals(
        0.5,
        run(values("variable place", "\"p[0.5, -0.2, 0.3, 0, 3.1416, 0]\""), 0)
            .endTcpInBase()
            .get(0),
        1e-6);
  }

  @Test
  void argumentOfOneLineAndSpeedsOfAllMovesAreSet() throws IOException, PlanException {
    double asWritten = run(values("seed", "1"), 0).durationS();
    assertTrue(run(values("argument 7 v", "0.2"), 0).durationS() > asWritten + 0.1);
    assertTrue(run(values("speed", "0.25"), 0).durationS() > asWritten + 0.1);
    assertEquals(asWritten, run(values("speed", "1"), 0).durationS());
    assertTrue(run(values("acceleration", "0.25"), 0).durationS() > asWritten + 0.1);
    assertTrue(run(values("slider", "0.5"), 0).durationS() > 1.5 * asWritten);
  }

  @Test
  void defaultOfAFunctionIsSet() throws IOException, PlanException {
    assertEquals(RunOutcome.FAILED, run(values("variable blend", "'\"far\"'"), 0).outcome());
  }

  @Test
  void placesInTheCellStayWhenTheBaseIsElsewhere() throws IOException, PlanException {
    String base = "[[parameter]]\nset = \"base x\"\nvalues = [0.1]\n" + values("base rz", "0.5");
    SweepResult moved = run("fixed = [\"place\"]\n" + base, 0);
    assertEquals(0.3 * Math.cos(0.5) - 0.2 * Math.sin(0.5), moved.endTcpInBase().get(0), 1e-5);
    assertEquals(-0.3 * Math.sin(0.5) - 0.2 * Math.cos(0.5), moved.endTcpInBase().get(1), 1e-5);
    assertEquals(0.4, run(base, 0).endTcpInBase().get(0), 1e-5);
  }

  @Test
  void inputRisesAtItsTime() throws IOException, PlanException {
    SweepJob job =
        job(
            """
            def waits():
              while not get_standard_digital_in(2):
                sync()
              end
            end
            """,
            values("input digital_in[2] time", "0.1, 0.5"));
    assertEquals(0.1, job.run(job.plan().variant(0)).durationS(), 0.01);
    assertEquals(0.5, job.run(job.plan().variant(1)).durationS(), 0.01);
  }

  @Test
  void runThatNeverEndsIsStoppedAtTheTimeLimit() throws IOException, PlanException {
    SweepJob job =
        job(
            """
            def turns():
              N = 0
              while True:
                N = N + 1
              end
            end
            """,
            "time_limit = 0.2\n" + values("variable N", "0"));
    SweepResult result = job.run(job.plan().variant(0));
    assertEquals(RunOutcome.NEVER_ENDED, result.outcome());
    assertEquals("still runs after 0.2 s", result.reason());
    assertEquals(0.2, result.durationS(), 0.01);
  }

  @Test
  void whateverIsWrongWithOneVariantIsItsResult() throws IOException, PlanException {
    SweepJob job = job(PROGRAM, values("variable FAST", "0.5, \"1 +\", \"1 / 0\", \"nobody\""));
    assertEquals(RunOutcome.FINISHED, job.run(job.plan().variant(0)).outcome());
    SweepResult broken = job.run(job.plan().variant(1));
    assertEquals(RunOutcome.DOES_NOT_COMPILE, broken.outcome());
    assertTrue(broken.reason().startsWith("line "), broken.reason());
    SweepResult failed = job.run(job.plan().variant(2));
    assertEquals(RunOutcome.FAILED, failed.outcome());
    assertEquals(2, failed.line());
    SweepResult slider = run(values("slider", "2"), 0);
    assertEquals(RunOutcome.REFUSED, slider.outcome());
    assertEquals("slider is 2, must be 0 to 1", slider.reason());
  }

  @Test
  void whatIsNotThereIsToldBeforeAnythingRuns() {
    List<String> mistakes =
        assertThrows(
                PlanException.class,
                () ->
                    job(
                        PROGRAM,
                        values("variable FSAT", "1")
                            + values("argument 7 speed", "1")
                            + values("argument 9000 v", "1")
                            + values("variable FAST[0]", "1")
                            + values("object box x", "1")
                            + values("base rx", "1")))
            .reports();
    String plan = folder.resolve("p.toml").toString();
    assertEquals(
        List.of(
            plan
                + ": error: variable FSAT: the program assigns no variable FSAT, did you mean"
                + " FAST?",
            plan + ": error: argument 7 speed: movej in line 7 has no parameter speed",
            plan + ": error: argument 9000 v: the program has 12 lines, line is 9000",
            plan
                + ": error: variable FAST[0]: FAST is not first assigned a list or pose with an"
                + " element 0",
            plan + ": error: object box x: the scene has no object \"box\"",
            plan
                + ": error: base rx: the base can be moved along x, y, z and turned about z, not"
                + " about rx"),
        mistakes);
  }

  @Test
  void identityChangesWithEveryFile() throws IOException, PlanException {
    String before = job(PROGRAM, values("seed", "1")).identity();
    assertEquals(before, job(PROGRAM, values("seed", "1")).identity());
    assertNotEquals(before, job(PROGRAM + "\n", values("seed", "1")).identity());
    assertNotEquals(before, job(PROGRAM, values("seed", "2")).identity());
  }

  /** A tetrahedron as OBJ; its size is in the file alone. */
  private void writeMesh(double size) throws IOException {
    Files.createDirectories(folder.resolve("cell/parts"));
    Files.writeString(
        folder.resolve("cell/parts/stop.obj"),
        "v 0 0 0\nv "
            + size
            + " 0 0\nv 0 "
            + size
            + " 0\nv 0 0 "
            + size
            + "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  }

  @Test
  void aMeshOfTheSceneBelongsToTheIdentity() throws IOException, PlanException {
    writeMesh(0.1);
    Files.writeString(
        folder.resolve("cell/a.scene.json"),
        """
        {"objects": [{"type": "mesh", "name": "stop", "pose": [2, 0, 0, 0, 0, 0],
          "mesh": "parts/stop.obj", "unit": "m"}]}
        """);
    String plan = "scene = \"cell/a.scene.json\"\n[[parameter]]\nset = \"slider\"\nvalues = [1]\n";
    SweepJob before = job(PROGRAM, plan);
    assertEquals(before.identity(), job(PROGRAM, plan).identity());
    assertTrue(before.files().contains("cell/parts/stop.obj"), before.files().toString());
    writeMesh(0.2);
    assertNotEquals(before.identity(), job(PROGRAM, plan).identity());
  }
}
