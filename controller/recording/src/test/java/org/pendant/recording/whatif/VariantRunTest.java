package org.pendant.recording.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.OptionalLong;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.recording.replay.Journal;
import org.pendant.recording.replay.ParkedRuns;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.recording.replay.SwitchOn;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.DebugRequest;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

final class VariantRunTest {
  private static final double FRAME_S = 0.002;
  private static final long START = 21;

  private static final String SWING =
      """
      movej([0.3, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=2, v=1)
      movel(pose_add(get_target_tcp_pose(), p[0.1, 0, 0.1, 0, 0, 0]), a=1, v=0.2)
      movej([-0.3, -1.2, -1.5708, -1.5708, 1.5708, 0], a=2, v=1)
      """;

  private final ControllerOptions options =
      ControllerOptions.headless().withSeed(3).withMeasuredNoise(true);
  private final Journal journal = Journal.of(new Controller(options));
  private final SwitchOn switchOn = SwitchOn.of(options, journal.controller().builtins());
  private final ParkedRuns parked = ParkedRuns.none(journal.run(), switchOn);
  private final Controller robot = journal.controller();

  private Program program(String text) {
    String whole = "def prog():\n" + text + "end\n";
    return robot
        .load(Source.of("play.script", whole.getBytes(StandardCharsets.ISO_8859_1)))
        .program()
        .orElseThrow();
  }

  private void submit(Command command) {
    var _ = robot.submit(command);
  }

  private void until(long frame) {
    while (robot.state().frame() < frame) {
      robot.advance();
    }
  }

  /** Runs a program to its end; answers how long it took from the frame in which it started. */
  private double play(String text) {
    until(START - 1);
    submit(new ProgramCommand.StartProgram(program(text)));
    robot.advance();
    while (robot.state().program().state() != ProgramState.STOPPED) {
      robot.advance();
    }
    return (robot.state().frame() - START) * FRAME_S;
  }

  private VariantOutcome run(Variant variant) throws RerunRefused {
    return VariantRun.fromStart(parked, 0, variant, VariantLimits.STANDARD).run();
  }

  private VariantOutcome run(long frame, Variant variant) throws RerunRefused {
    return VariantRun.from(frame, parked, 0, variant, VariantLimits.STANDARD).run();
  }

  @Test
  void theUnchangedVariantIsTheRunBitForBit() throws RerunRefused {
    TcpWay.Builder way = new TcpWay.Builder(20_000);
    until(START - 1);
    way.add(robot.state().arm().actualTcpInBase());
    submit(new ProgramCommand.StartProgram(program(SWING)));
    do {
      robot.advance();
      way.add(robot.state().arm().actualTcpInBase());
    } while (robot.state().program().state() != ProgramState.STOPPED);
    ControllerState end = robot.state();
    until(end.frame() + 50);

    VariantOutcome outcome = run(Variant.asItWas("as it was"));

    assertEquals(VariantOutcome.End.FINISHED, outcome.end());
    assertEquals((end.frame() - START) * FRAME_S, outcome.cycleS().orElseThrow());
    assertEquals(way.way(), outcome.way());
    assertTrue(outcome.way().size() > 100, outcome.way().toString());
    assertEquals(0, outcome.roundOf());
  }

  @Test
  void theRestOfARunIsAsItWasToo() throws RerunRefused {
    double cycleS = play(SWING);
    VariantOutcome outcome = run(400, Variant.asItWas("as it was"));
    assertEquals(cycleS, outcome.cycleS().orElseThrow());
    assertEquals((START - 400) * FRAME_S + cycleS, outcome.timeS(), 1e-9);
  }

  @Test
  void halfTheSpeedTakesLongerAndLessOfTheJoints() throws RerunRefused {
    play(SWING);
    VariantOutcome whole = run(Variant.asItWas("whole"));
    VariantOutcome half = run(Variant.asItWas("half").withSpeed(0.5));
    // paths take twice as long; what starts and ends a motion does not
    assertEquals(2, half.timeS() / whole.timeS(), 0.1);
    assertEquals(
        0.5,
        half.jointSpeed().orElseThrow().share() / whole.jointSpeed().orElseThrow().share(),
        0.02);
    assertEquals(half.way().x(half.way().size() - 1), whole.way().x(whole.way().size() - 1), 1e-3);
  }

  @Test
  void aHeavierLoadTakesMoreTorqueAndEnergy() throws RerunRefused {
    play("set_payload(2, [0, 0, 0.05])\n" + SWING);
    VariantOutcome light = run(Variant.asItWas("as it was"));
    VariantOutcome heavy = run(Variant.asItWas("heavy").withLoad(3));
    assertEquals(VariantOutcome.End.FINISHED, heavy.end(), heavy.words());
    assertTrue(heavy.torque().orElseThrow().share() > light.torque().orElseThrow().share());
    assertTrue(heavy.energyJ() > light.energyJ(), heavy.energyJ() + " J, " + light.energyJ());
    assertEquals("shoulder", light.torque().orElseThrow().joint());
    assertTrue(light.torque().orElseThrow().line() >= 3);
  }

  @Test
  void anotherProgramStartsWhereTheOldOneDid() throws RerunRefused {
    play(SWING);
    Program faster = program(SWING.replace("v=1", "v=2").replace("a=2", "a=5"));
    VariantOutcome old = run(300, Variant.asItWas("old"));
    VariantOutcome other = run(300, Variant.asItWas("faster").withProgram(faster));
    assertEquals(VariantOutcome.End.FINISHED, other.end());
    assertTrue(other.cycleS().orElseThrow() < old.cycleS().orElseThrow());
    assertEquals(other.cycleS().orElseThrow(), other.timeS(), 2 * FRAME_S);
  }

  @Test
  void whatCameFromOutsideComesAgain() throws RerunRefused {
    until(START - 1);
    submit(
        new ProgramCommand.StartProgram(
            program(
                """
                while not get_standard_digital_in(2):
                  sync()
                end
                popup("go on", blocking=True)
                """)));
    until(300);
    submit(new IoCommand.SetInput("digital_in[2]", true));
    until(400);
    VariantOutcome outcome = run(Variant.asItWas("as it was"));
    assertEquals(VariantOutcome.End.FINISHED, outcome.end(), outcome.words());
    assertEquals((301 - START) * FRAME_S, outcome.cycleS().orElseThrow(), 0.05);
  }

  @Test
  void breakpointsAndPausesDoNotHoldIt() throws RerunRefused {
    until(START - 1);
    submit(new DebugCommand.Debug(new DebugRequest.SetBreakpoint(Breakpoint.at(3))));
    submit(new ProgramCommand.StartProgram(program(SWING)));
    for (int i = 0; i < 3000 && !robot.state().debug().held(); i++) {
      robot.advance();
    }
    assertTrue(robot.state().debug().held());
    VariantOutcome outcome = run(robot.state().frame(), Variant.asItWas("as it was"));
    assertEquals(VariantOutcome.End.FINISHED, outcome.end(), outcome.words());
    assertEquals(outcome.cycleS(), run(Variant.asItWas("from the start")).cycleS());
  }

  @Test
  void aProgramThatNeverEndsIsToldByItsRounds() throws RerunRefused {
    until(START - 1);
    submit(
        new ProgramCommand.StartProgram(
            program(
                "while True:\nsleep(0.5)\ni = 0\nwhile i < 3:\ni = i + 1\nsync()\nend\nend\n")));
    until(START);
    VariantOutcome outcome =
        VariantRun.fromStart(
                parked,
                0,
                Variant.asItWas("as it was"),
                new VariantLimits(Duration.ofSeconds(5), Duration.ofMinutes(1)))
            .run();
    assertEquals(VariantOutcome.End.LIMIT, outcome.end());
    assertEquals(5, outcome.timeS(), 1e-9);
    assertEquals(0.506, outcome.cycleS().orElseThrow(), 0.005);
    assertTrue(outcome.roundOf() >= 3, "line " + outcome.roundOf());
  }

  @Test
  void whatStopsTheArmIsTold() throws RerunRefused {
    play(SWING);
    VariantOutcome failed = run(Variant.asItWas("bad").withProgram(program("movej([1])\n")));
    assertEquals(VariantOutcome.End.FAILED, failed.end());
    assertTrue(failed.words().startsWith("line 2: "), failed.words());
    VariantOutcome heavy = run(Variant.asItWas("heavy").withLoad(30));
    assertEquals(VariantOutcome.End.STOPPED, heavy.end());
    assertFalse(heavy.words().isEmpty());
  }

  @Test
  void aRunThatCannotBeRepeatedIsRefused() {
    RerunRefused none = assertThrows(RerunRefused.class, () -> run(Variant.asItWas("as it was")));
    assertEquals("no program has been started yet", none.getMessage());
    play("sleep(0.1)\n");
    RerunRefused later =
        assertThrows(RerunRefused.class, () -> run(100_000, Variant.asItWas("as it was")));
    assertTrue(later.getMessage().startsWith("frame is 100000, must be"), later.getMessage());
    long end = robot.state().frame();
    RerunRefused ended =
        assertThrows(RerunRefused.class, () -> run(end, Variant.asItWas("as it was")));
    assertEquals("no program runs at that moment", ended.getMessage());
  }

  @Test
  void aVariantFromAParkedRunIsTheSame() throws RerunRefused {
    ParkedRuns near = new ParkedRuns(journal.run(), switchOn, Runnable::run);
    play("sleep(30)\n" + SWING);
    long moment = robot.state().frame() - 400;
    VariantOutcome expected = run(moment, Variant.asItWas("as it was"));
    near.look(OptionalLong.of(moment));
    VariantOutcome outcome =
        VariantRun.from(moment, near, 0, Variant.asItWas("as it was"), VariantLimits.STANDARD)
            .run();
    assertEquals(expected, outcome);
  }

  @Test
  void itCanBeCancelled() throws RerunRefused {
    play(SWING);
    VariantRun run =
        VariantRun.fromStart(parked, 0, Variant.asItWas("as it was"), VariantLimits.STANDARD);
    run.cancel();
    assertThrows(CancellationException.class, run::run);
  }
}
