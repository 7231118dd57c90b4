package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Wrench;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;

/** Programs that run toolpaths, from outside, on an arm with mass. */
@Tag("slow")
final class ToolpathProgramTest {
  private static final int MAX_FRAMES = 60_000;

  /** A square of 60 mm with corners cut by 45 degrees, 10 mm above the start of the path. */
  private static final String SQUARE =
      """
      %SQUARE
      N10 G54
      N20 S900 M3 ; spindle
      N30 G00 X0 Y0 Z10. F6000
      N40 G01 X30. F1500
      N50 X40. Y10.
      N60 Y40.
      N70 X30. Y50.
      N80 X0.
      """;

  /** A part that lies at the tool, whose z-axis points into the flange. */
  private static final String BEGIN =
      """
        tcp = p[0, 0, 0.1, 3.14159265358979, 0, 0]
        here = pose_trans(get_actual_tcp_pose(), tcp)
      """;

  @TempDir private Path folder;

  private Controller controller;
  private final List<LogEntry> entries = new ArrayList<>();

  private void file(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private void start(String body) {
    controller =
        new Controller(ControllerOptions.headless().withProgramsFolder(ProgramsFolder.at(folder)));
    entries.clear();
    String text = "def prog():\n" + BEGIN + body + "\nend\n";
    LoadResult loadResult =
        controller.load(Source.of("t.script", text.getBytes(StandardCharsets.ISO_8859_1)));
    assertTrue(loadResult.program().isPresent(), () -> loadResult.diagnostics().toString());
    var _ = controller.submit(new ProgramCommand.StartProgram(loadResult.program().get()));
    advance();
  }

  private void advance() {
    controller.advance();
    entries.addAll(controller.state().newEntries());
  }

  private boolean running() {
    return controller.state().program().state() == ProgramState.RUNNING;
  }

  private List<Joints> run(String body) {
    start(body);
    List<Joints> targets = new ArrayList<>();
    while (running() && targets.size() < MAX_FRAMES) {
      advance();
      targets.add(controller.state().arm().targetPositionRad());
    }
    return targets;
  }

  private List<String> said() {
    return entries.stream()
        .filter(entry -> entry.origin() == Origin.SCRIPT)
        .map(LogEntry::text)
        .toList();
  }

  private String failure() {
    return controller.state().program().ending().orElseThrow() instanceof Ending.Failed failed
        ? failed.failure().message()
        : "ended well";
  }

  private static String square(String run) {
    return """
      mc_initialize(0, tcp, doc=6)
      mc_set_pcs(here)
      path = mc_load_path("square.nc", useFeedRate=True)
      id = mc_add_path(path, a=1.2, v=0.0, r=0.002)
    """
        + run;
  }

  @Test
  void aFileIsRunAtItsFeedRates() throws IOException {
    file("square.nc", SQUARE);
    int frames = run(square("mc_run_motion(id)\n textmsg(\"done\")")).size();
    assertEquals("ended well", failure());
    assertEquals(List.of("done"), said());
    double cut = 2 * Math.hypot(10, 10);
    double expectedS = 10 / 100.0 + (30 + 30 + 30 + cut) / 25.0;
    assertEquals(expectedS, frames * 0.002, 0.25);
  }

  @Test
  void codesWithoutEffectAreListedOnce() throws IOException {
    file("square.nc", SQUARE);
    run(square(""));
    List<String> told =
        entries.stream().map(LogEntry::text).filter(text -> text.contains("effect")).toList();
    assertEquals(
        List.of("mc_load_path: square.nc has codes without effect on a robot: G54, S, M3"), told);
  }

  @Test
  void aBrokenLineIsToldBeforeAnythingMoves() throws IOException {
    file("bad.nc", "G01 X0 Y0 Z0 F100\nX5\nG02 X9 Y9\n");
    run(
        """
          mc_initialize(0, tcp)
          mc_add_linear(pose_add(here, p[0, 0.05, 0, 0, 0, 0]), 1, 0.2, 0)
          mc_add_path(mc_load_path("/programs/bad.nc", False), 1, 0.1, 0)
          mc_run_motion()
        """);
    assertEquals(
        "mc_load_path: bad.nc:3: G02 asks for an arc, must be straight lines (G01)", failure());
    assertEquals(BoxSetup.START_RAD, controller.state().arm().targetPositionRad());
  }

  @Test
  void aFeedRateMustBeGivenWhereItCounts() throws IOException {
    file("slow.nc", "G01 X0 Y0 Z0\nX5 F100\n");
    run("mc_load_path(\"slow.nc\", useFeedRate=True)");
    assertTrue(failure().startsWith("mc_load_path: slow.nc:1: no feed rate yet"), failure());
    run("textmsg(mc_load_path(\"slow.nc\", useFeedRate=False))");
    assertEquals(List.of("0"), said());
  }

  @Test
  void aSpeedMustBeGivenWhereNoFeedRateCounts() throws IOException {
    file("square.nc", SQUARE);
    run(
        """
          mc_initialize(0, tcp)
          mc_add_path(mc_load_path("square.nc", False), 1, 0, 0)
        """);
    assertEquals("mc_add_path: v is 0 m/s, must be above 0", failure());
    run("mc_initialize(0, tcp)\n mc_load_path(\"square.nc\", False)\n mc_add_path(1, 1, 0.1, 0)");
    assertEquals("mc_add_path: path_id is 1, must be 0 to 0", failure());
  }

  @Test
  void aFileOutsideTheFolderIsRefused() {
    run("mc_load_path(\"../other.nc\", True)");
    assertEquals("mc_load_path: \"../other.nc\" leads out of the programs folder", failure());
  }

  @Test
  void aLargeFileIsReadBesideTheFramesAndRunsRepeatExactly() throws IOException {
    StringBuilder large = new StringBuilder("G01 X0 Y0 Z0 F3000\n");
    for (int i = 1; i <= 6000; i++) {
      large.append("G01 X").append(i * 0.005).append(" Y0.0000 Z0.0000 B0.0000 C0.0000 F3000\n");
    }
    file("large.nc", large.toString());
    String body =
        """
          mc_initialize(0, tcp)
          mc_set_pcs(here)
          mc_add_path(mc_load_path("large.nc", True), 1, 0, 0)
          mc_run_motion()
        """;
    List<Joints> first = run(body);
    assertEquals("ended well", failure());
    assertTrue(first.size() > 0.03 / 0.05 * 500);
    assertEquals(first, run(body));
  }

  @Test
  void aThreadSlowsTheToolDownOnItsWay() throws IOException {
    file("square.nc", SQUARE);
    List<Joints> plain = run(square("mc_run_motion()"));
    List<Joints> slowed =
        run(
            square(
                """
                thread Slow():
                  sleep(1)
                  mc_set_speed_factor(0.25)
                  sleep(1)
                  mc_set_speed_factor(0)
                  sleep(0.5)
                  mc_set_speed_factor(1)
                end
                run Slow()
                mc_run_motion()
                """));
    assertEquals("ended well", failure());
    assertEquals(plain.size() + (0.75 + 0.5) * 500, slowed.size(), 30);
    for (Joints point : slowed) {
      double nearest =
          plain.stream().mapToDouble(each -> each.maxAbsDifference(point)).min().orElseThrow();
      assertTrue(nearest < 1e-3, nearest + " rad beside the path");
    }
    assertTrue(slowed.getLast().maxAbsDifference(plain.getLast()) < 1e-12);
  }

  @Test
  void aPauseChangesNoPointOfThePath() throws IOException {
    file("square.nc", SQUARE);
    List<Joints> plain = run(square("mc_run_motion()"));
    for (int at = 200; at < plain.size(); at += 400) {
      start(square("mc_run_motion()"));
      for (int i = 0; i < at; i++) {
        advance();
      }
      var _ = controller.submit(new ProgramCommand.PauseProgram());
      for (int i = 0; i < 100; i++) {
        advance();
      }
      assertEquals(Joints.ZERO, controller.state().arm().targetSpeedRadPerS());
      var _ = controller.submit(new ProgramCommand.ResumeProgram());
      for (int i = 0; i < MAX_FRAMES && (i == 0 || running()); i++) {
        advance();
      }
      assertEquals("ended well", failure());
      assertEquals(plain.getLast(), controller.state().arm().targetPositionRad());
    }
  }

  @Test
  void theSpeedOverThePartIsThatOfTheMotion() {
    run(
        """
          flange = get_actual_tcp_pose()
          mc_initialize(1, pose_trans(flange, p[0, 0, 0.2, 0, 0, 0]))
          mc_set_pcs(p[0, 0, 0.2, 0, 0, 0])
          mc_add_linear(p[0.05, 0, 0, 0, 0, 0.4], 1.2, 0.05, 0)
          fastest = 0.0
          thread Look():
            while True:
              if mc_get_target_rtcp_speed() > fastest:
                fastest = mc_get_target_rtcp_speed()
              end
              sync()
            end
          end
          looking = run Look()
          mc_run_motion()
          kill looking
          textmsg(fastest > 0.04999 and fastest < 0.05001)
        """);
    assertEquals("ended well", failure());
    assertEquals(List.of("True"), said());
  }

  @Test
  void aToolBesideItsPathEndsTheProgram() {
    // what bends the arm a little moves the tip of a very long tool a lot
    start(
        """
          long = p[3, 0, 0.1, 0, 0, 0]
          tip = pose_trans(get_actual_tcp_pose(), long)
          mc_initialize(0, long)
          mc_add_linear(pose_add(tip, p[0, 0, 0.05, 0, 0, 0]), 0.5, 0.01, 0)
          mc_run_motion()
        """);
    for (int i = 0; i < 500; i++) {
      advance();
    }
    assertTrue(running());
    for (int i = 0; i < 1000 && running(); i++) {
      double twistNm = 0.05 * i;
      var _ = controller.submit(new WorldCommand.PushTool(new Wrench(0, 0, 0, 0, 0, twistNm)));
      advance();
    }
    assertTrue(
        failure().startsWith("mc_run_motion: the tool is 5.")
            && failure().endsWith("mm beside its path, must be within 5 mm"),
        failure());
  }

  @Test
  void anotherThreadCannotRunMotionsMeanwhile() {
    run(
        """
          mc_initialize(0, tcp)
          mc_add_linear(pose_add(here, p[0, 0.1, 0, 0, 0, 0]), 1, 0.1, 0)
          thread Other():
            sleep(0.3)
            mc_run_motion()
          end
          run Other()
          mc_run_motion()
        """);
    assertEquals("mc_run_motion: another thread runs motions, only one can at a time", failure());
  }

  @Test
  void aSequenceCannotBeginWhileOneRuns() {
    run(
        """
          mc_initialize(0, tcp)
          mc_add_linear(pose_add(here, p[0, 0.1, 0, 0, 0, 0]), 1, 0.1, 0)
          thread Other():
            sleep(0.3)
            mc_initialize(0, tcp)
          end
          run Other()
          mc_run_motion()
        """);
    assertTrue(failure().startsWith("mc_initialize: motions are being run"), failure());
  }

  @Test
  void aKilledRunComesToRestAndTheNextSequenceCanBegin() {
    run(
        """
          mc_initialize(0, tcp)
          mc_add_linear(pose_add(here, p[0, 0.1, 0, 0, 0, 0]), 1, 0.1, 0)
          thread Mover():
            mc_run_motion()
          end
          mover = run Mover()
          sleep(0.5)
          kill mover
          sleep(0.5)
          mc_initialize(0, tcp)
          mc_add_linear(here, 1, 0.1, 0)
          mc_run_motion()
          textmsg("back")
        """);
    assertEquals("ended well", failure());
    assertEquals(List.of("back"), said());
  }

  @Test
  void aPathAddedAtAnotherSpeedIsWarnedOf() throws IOException {
    file("square.nc", SQUARE);
    run(
        """
          mc_initialize(0, tcp)
          mc_set_pcs(here)
          path = mc_load_path("square.nc", False)
          mc_add_path(path, 1, 0.1, 0.001)
          mc_add_path(path, 1, 0.1, 0.002)
          mc_add_path(path, 1, 0.2, 0.001)
        """);
    long warnings =
        entries.stream().filter(entry -> entry.level() == LogEntry.Level.WARNING).count();
    assertEquals(1, warnings);
  }

  @Test
  void theToolEndsWhereTheFileSays() throws IOException {
    file("square.nc", SQUARE);
    start(square("mc_run_motion()"));
    Pose flange = controller.state().arm().targetTcpInBase();
    Pose part = Poses.trans(flange, new Pose(0, 0, 0.1, Math.PI, 0, 0));
    while (running()) {
      advance();
    }
    Pose end =
        Poses.trans(controller.state().arm().targetTcpInBase(), new Pose(0, 0, 0.1, Math.PI, 0, 0));
    Pose expected = Poses.trans(part, new Pose(0, 0.05, 0.01, 0, 0, 0));
    assertTrue(Poses.distance(expected, end) < 1e-8, end + " instead of " + expected);
  }
}
