package org.pendant.recording.lines;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ProgramState;

/** What lines take of a run, by programs of which that is known exactly. */
final class LineProfilerTest {
  private static final double FRAME_S = 0.002;

  private final ControllerOptions options = ControllerOptions.headless().withArm(ArmChoice.IDEAL);

  private static LineProfiler run(ControllerOptions options, String text) {
    Controller controller = new Controller(options);
    LineProfiler profiler = new LineProfiler(controller::programSource, options::safety);
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
    for (int i = 0; i < 20_000; i++) {
      controller.advance();
      profiler.see(controller.state());
      if (controller.state().program().state() == ProgramState.STOPPED && i > 0) {
        return profiler;
      }
    }
    throw new AssertionError("the program does not end");
  }

  private RunProfile profile(String text) {
    return run(options, text).profile();
  }

  private static LineStatistics line(RunProfile profile, int line) {
    return profile.line(line).orElseThrow();
  }

  @Test
  void aMoveOfAKnownTimeTakesThatTime() {
    RunProfile profile =
        profile(
            """
            home = [0, -1.5708, -1.5708, -1.5708, 1.5708, 0]
            movej(home)
            movej([0.5, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=2)
            sleep(1)
            """);

    LineStatistics move = line(profile, 3);
    assertEquals(2, move.timeS(), FRAME_S);
    assertEquals(1, move.executions());
    assertEquals(move.frames(), move.longestFrames());
    assertTrue(move.moved());
    assertEquals(1, line(profile, 4).timeS(), FRAME_S);
    assertFalse(line(profile, 4).moved());
    assertEquals("base", move.worst(Margin.JOINT_SPEED).orElseThrow().part());
  }

  @Test
  void aLinearMoveHasItsLengthAndItsSpeed() {
    RunProfile profile =
        profile(
            """
            movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])
            movel(pose_add(get_target_tcp_pose(), p[0, 0, 0.2, 0, 0, 0]), a=1, v=0.1)
            """);

    LineStatistics move = line(profile, 2);
    assertEquals(0.2, move.pathM(), 1e-6);
    assertEquals(0.1, move.toolSpeedMPerS(), 1e-6);
    assertEquals(0.2 / 0.1 + 0.1 / 1, move.timeS(), 0.05);
  }

  @Test
  void aJointMoveReachesItsSpeedAndSaysOfWhichJoint() {
    RunProfile profile =
        profile(
            """
            movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])
            movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 2], a=10, v=1.57079632679)
            """);

    Worst speed = line(profile, 2).worst(Margin.JOINT_SPEED).orElseThrow();
    assertEquals("wrist 3", speed.part());
    assertEquals(0.5, speed.value(), 1e-6, "wrist 3 of a UR5e can do 180 deg/s");
    Worst limit = line(profile, 2).worst(Margin.JOINT_LIMIT).orElseThrow();
    assertEquals("wrist 3", limit.part());
    assertEquals(Math.toRadians(363) - 2, limit.value(), 1e-6);
  }

  @Test
  void aLoopCountsItsTurnsAndKeepsTheLongest() {
    RunProfile profile =
        profile(
            """
            there = [0.2, -1.5708, -1.5708, -1.5708, 1.5708, 0]
            i = 0
            while i < 3:
              movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=1 + i)
              movej(there, t=1)
              i = i + 1
            end
            """);

    LineStatistics first = line(profile, 4);
    assertEquals(3, first.executions());
    assertEquals(6, first.timeS(), 3 * FRAME_S);
    assertEquals(3, first.longestS(), FRAME_S);
    assertEquals(6 / 9.0, profile.share(first), 0.001);
  }

  @Test
  void oneLineThatMovesAgainAndAgainCountsEachMove() {
    RunProfile profile =
        profile(
            """
            i = 0
            while i < 4:
              movej([0.1 * i, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=0.5)
              i = i + 1
            end
            """);

    LineStatistics move = line(profile, 3);
    assertEquals(4, move.executions());
    assertEquals(0.5, move.longestS(), FRAME_S);
  }

  @Test
  void aPlaneTellsTheSmallestDistanceOfTheTool() {
    SafetyPlane floor = new SafetyPlane("Table", 0, 0, 0, new Axis(0, 0, 1), Applies.BOTH, false);
    ControllerOptions withPlane = options.withSafety(options.safety().withPlanes(floor));
    RunProfile profile =
        run(
                withPlane,
                """
                movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])
                movel(p[-0.3, -0.2, 0.25, 0, 3.1416, 0], v=0.5)
                movel(p[-0.3, -0.2, 0.05, 0, 3.1416, 0], v=0.5)
                movel(p[-0.3, -0.2, 0.25, 0, 3.1416, 0], v=0.5)
                """)
            .profile();

    Worst nearest = line(profile, 3).worst(Margin.PLANE).orElseThrow();
    assertEquals(0.05, nearest.value(), 1e-6);
    assertEquals("Table", nearest.part());
    RunProfile.Moment worst =
        profile.worst().stream()
            .filter(each -> each.worst().margin() == Margin.PLANE)
            .findFirst()
            .orElseThrow();
    assertEquals(3, worst.line());
    assertEquals(nearest, worst.worst());
  }

  @Test
  void eachMarginStandsAtItsIndex() {
    int index = 0;
    for (Margin each : Margin.values()) {
      assertEquals(index, each.index());
      index++;
    }
  }

  @Test
  void withoutPlanesThereIsNoDistanceToOne() {
    RunProfile profile = profile("movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])\n");

    assertEquals(Optional.empty(), line(profile, 1).worst(Margin.PLANE));
  }

  @Test
  void theNextProgramBeginsAnew() {
    Controller controller = new Controller(options);
    LineProfiler profiler = new LineProfiler(controller::programSource, options::safety);
    for (String text : List.of("sleep(0.5)\nsleep(0.5)\n", "sleep(0.1)\n")) {
      var _ =
          controller.submit(
              new ProgramCommand.StartProgram(TestController.program(controller, text)));
      for (int i = 0; i < 600; i++) {
        controller.advance();
        profiler.see(controller.state());
      }
    }

    assertEquals(
        List.of(1), profiler.profile().lines().stream().map(LineStatistics::line).toList());
  }

  @Test
  void aRecordingTellsTheSameAsTheRun() {
    Controller controller = new Controller(options.withArm(ArmChoice.DYNAMIC));
    LineProfiler profiler = new LineProfiler(controller::programSource, options::safety);
    RecordingRing ring = new RecordingRing(controller.state(), controller::programSource);
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                TestController.program(
                    controller,
                    """
                    movej([0.5, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=1)
                    sleep(2)
                    movel(pose_add(get_target_tcp_pose(), p[0, 0, 0.1, 0, 0, 0]), v=0.5)
                    """)));
    for (int i = 0; i < 3_000; i++) {
      controller.advance();
      profiler.see(controller.state());
      ring.take(controller.state());
    }

    assertEquals(profiler.profile(), LineProfiler.of(ring.recording(), options.safety()));
  }

  @Test
  void aPausedProgramTakesNoTime() {
    Controller controller = new Controller(options);
    LineProfiler profiler = new LineProfiler(controller::programSource, options::safety);
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                TestController.program(
                    controller, "movej([1, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=3)\n")));
    for (int i = 0; i < 5_000; i++) {
      if (i == 500) {
        var _ = controller.submit(new ProgramCommand.PauseProgram());
      }
      if (i == 2_000) {
        var _ = controller.submit(new ProgramCommand.ResumeProgram());
      }
      controller.advance();
      profiler.see(controller.state());
    }

    LineStatistics move = line(profiler.profile(), 1);
    assertTrue(move.timeS() > 2.9 && move.timeS() < 3.5, move.timeS() + " s");
    assertEquals(1, move.executions());
  }

  @Test
  void aRunThatGoesOnOtherwiseFromAMomentHasWhatItTookUntilThen() {
    Controller controller = new Controller(options);
    LineProfiler profiler = new LineProfiler(controller::programSource, options::safety);
    RecordingRing ring = new RecordingRing(controller.state(), controller::programSource);
    List<RunProfile> seen = new ArrayList<>();
    List<Recording> pasts = new ArrayList<>();
    for (int run = 0; run < 2; run++) {
      var _ =
          controller.submit(
              new ProgramCommand.StartProgram(
                  TestController.program(
                      controller,
                      """
                      movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=0.2)
                      movej([0.1, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=0.2)
                      """)));
      for (int i = 0; i < 250; i++) {
        controller.advance();
        ring.take(controller.state());
        profiler.see(controller.state());
        if (i == 150) {
          seen.add(profiler.profile());
          pasts.add(ring.recording());
        }
      }
    }

    for (int i = 0; i < seen.size(); i++) {
      assertEquals(seen.get(i), profiler.until(pasts.get(i), options.safety()).profile());
    }
  }

  @Test
  void aRunThatIsHeldInItsFirstFrameIsKnownWhenItGoesOnOtherwise() {
    Controller controller = new Controller(options);
    LineProfiler profiler = new LineProfiler(controller::programSource, options::safety);
    RecordingRing ring = new RecordingRing(controller.state(), controller::programSource);
    var _ =
        controller.submit(
            new DebugCommand.Debug(
                debugger -> {
                  debugger.set(Breakpoint.at(2));
                }));
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                TestController.program(
                    controller,
                    """
                    a = 1
                    b = 2
                    movej([0.1, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=0.2)
                    """)));
    boolean held = false;
    for (int i = 0; i < 100; i++) {
      controller.advance();
      if (controller.state().debug().held()) {
        held = true;
        profiler.see(controller.state());
        ring.take(controller.state());
        var _ = controller.submit(new DebugCommand.Debug(Debugger::resume));
        controller.advance();
      }
      profiler.see(controller.state());
      ring.take(controller.state());
    }

    assertTrue(held);
    assertEquals(3, profiler.profile().lines().getLast().line());
    assertEquals(profiler.profile(), profiler.until(ring.recording(), options.safety()).profile());
    RunProfile ofFile = LineProfiler.of(ring.recording(), options.safety());
    assertEquals(profiler.profile().lines(), ofFile.lines());
  }
}
