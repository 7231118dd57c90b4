package org.pendant.recording.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.replay.CellPlay;
import org.pendant.recording.replay.ParkedRuns;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.DebugRequest;
import org.pendant.script.vm.ProgramState;

/** Variants of one controller of a cell; the others do what they did. */
final class CellVariantTest {
  private static final int LEFT = 0;
  private static final int RIGHT = 1;
  private static final double FRAME_S = 0.002;

  private static final String SCENE =
      """
      {
        "arms": [
          {"name": "left"},
          {"name": "right", "base": [2, 0, 0, 0, 0, 3.141592653589793]}
        ],
        "wires": [["left.digital_out[0]", "right.digital_in[0]"],
                  ["right.digital_out[0]", "left.digital_in[0]"]]
      }
      """;

  /** Moves and has the other move, and waits for it. */
  private static final String ASKS =
      """
      def asks():
        movej([0.3, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=2, v=1)
        set_standard_digital_out(0, True)
        while not get_standard_digital_in(0):
          sync()
        end
      end
      """;

  /** Moves when the other has, and waits for a hand before it says so. */
  private static final String ANSWERS =
      """
      def answers():
        while not get_standard_digital_in(0):
          sync()
        end
        movej([0.6, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=2, v=1)
        while not get_standard_digital_in(3):
          sync()
        end
        set_standard_digital_out(0, True)
      end
      """;

  private final CellPlay play = new CellPlay(SCENE, ControllerOptions.headless().withSeed(3));
  private final ParkedRuns parked = ParkedRuns.none(play.journal(), play.switchOn());

  private VariantOutcome fromStart(Variant variant) throws RerunRefused {
    return VariantRun.fromStart(parked, LEFT, variant, VariantLimits.STANDARD).run();
  }

  /** When the program of the left arm ended, s since it began. */
  private double ran(long started) {
    ControllerState left = play.controller(LEFT).state();
    assertEquals(ProgramState.STOPPED, left.program().state());
    return (left.frame() - started) * FRAME_S;
  }

  @Test
  void oneAsItWasTakesAsLongAsTheRunDidAndTheOthersStartAgain() throws RerunRefused {
    play.start(21, LEFT, ASKS)
        .start(81, RIGHT, ANSWERS)
        .at(1000, RIGHT, new IoCommand.SetInput("digital_in[3]", true));
    for (long frame = 100;
        play.controller(LEFT).state().program().state() != ProgramState.STOPPED || frame == 100;
        frame++) {
      play.until(frame);
    }
    VariantOutcome outcome = fromStart(Variant.asItWas("as it was"));
    assertEquals(VariantOutcome.End.FINISHED, outcome.end(), outcome.words());
    assertEquals(ran(21), outcome.cycleS().orElseThrow(), 1e-9);
  }

  @Test
  void aSlowerArmKeepsTheOthersWaiting() throws RerunRefused {
    play.start(21, LEFT, ASKS)
        .start(21, RIGHT, ANSWERS)
        .at(22, RIGHT, new IoCommand.SetInput("digital_in[3]", true))
        .until(1500);
    double asItWasS = fromStart(Variant.asItWas("as it was")).cycleS().orElseThrow();
    VariantOutcome half = fromStart(Variant.asItWas("half").withSpeed(0.5));
    assertEquals(VariantOutcome.End.FINISHED, half.end(), half.words());
    double own = (0.3 / 1 + 1.0 / 2) * 0.5;
    assertTrue(half.cycleS().orElseThrow() > asItWasS + own / 2, () -> half.toString());
    assertTrue(half.cycleS().orElseThrow() < 2 * asItWasS, "the other arm is as fast as it was");
  }

  @Test
  void fromAMomentAllGoOnFromThere() throws RerunRefused {
    play.start(21, LEFT, ASKS)
        .start(21, RIGHT, ANSWERS)
        .at(1200, RIGHT, new IoCommand.SetInput("digital_in[3]", true))
        .until(1500);
    VariantOutcome outcome =
        VariantRun.from(500, parked, LEFT, Variant.asItWas("on"), VariantLimits.STANDARD).run();
    assertEquals(VariantOutcome.End.FINISHED, outcome.end(), outcome.words());
    assertEquals((1200 - 500) * FRAME_S, outcome.timeS(), 5 * FRAME_S);
  }

  @Test
  void whatPausedAnyOfTheProgramsDoesNotComeAgain() throws RerunRefused {
    play.at(2, RIGHT, new DebugCommand.Debug(new DebugRequest.SetBreakpoint(Breakpoint.at(6))))
        .start(21, LEFT, ASKS)
        .start(21, RIGHT, ANSWERS)
        .at(22, RIGHT, new IoCommand.SetInput("digital_in[3]", true))
        .at(30, RIGHT, new ProgramCommand.PauseProgram())
        .until(200);
    VariantOutcome outcome = fromStart(Variant.asItWas("as it was"));
    assertEquals(VariantOutcome.End.FINISHED, outcome.end(), outcome.words());
  }

  @Test
  void oneThatWaitsForAnotherThatHasFailedSaysSo() throws RerunRefused {
    play.start(21, LEFT, ASKS)
        .start(21, RIGHT, "def answers():\n  sleep(0.5)\n  sleep(0 - 1)\nend\n")
        .until(900);
    VariantLimits limits = new VariantLimits(Duration.ofSeconds(2), Duration.ofSeconds(60));
    VariantOutcome outcome =
        VariantRun.fromStart(parked, LEFT, Variant.asItWas("as it was"), limits).run();
    assertEquals(VariantOutcome.End.LIMIT, outcome.end());
    assertTrue(outcome.words().startsWith("runs on at 2 s; right: line 3: "), outcome.words());
  }

  @Test
  void oneThatADebuggerHasPausedAtTheMomentGoesOn() throws RerunRefused {
    play.at(2, RIGHT, new DebugCommand.Debug(new DebugRequest.SetBreakpoint(Breakpoint.at(6))))
        .start(21, LEFT, ASKS)
        .start(21, RIGHT, ANSWERS)
        .at(22, RIGHT, new IoCommand.SetInput("digital_in[3]", true))
        .until(200);
    while (!play.controller(RIGHT).held()) {
      play.journal().controllers().frames().advance();
    }
    long held = play.controller(LEFT).state().frame();
    VariantOutcome outcome =
        VariantRun.from(held, parked, LEFT, Variant.asItWas("on"), VariantLimits.STANDARD).run();
    assertEquals(VariantOutcome.End.FINISHED, outcome.end(), outcome.words());
  }

  @Test
  void aProgramThatGaveWayToAnotherDoesSoAgain() throws RerunRefused {
    play.start(21, LEFT, ASKS)
        .start(21, RIGHT, "def idle():\n  sleep(1000)\nend\n")
        .at(200, RIGHT, new ProgramCommand.StopProgram())
        .start(202, RIGHT, ANSWERS)
        .at(203, RIGHT, new IoCommand.SetInput("digital_in[3]", true))
        .at(1900, RIGHT, new ProgramCommand.StopProgram())
        .until(2000);
    VariantOutcome outcome = fromStart(Variant.asItWas("as it was"));
    assertEquals(VariantOutcome.End.FINISHED, outcome.end(), outcome.words());
  }
}
