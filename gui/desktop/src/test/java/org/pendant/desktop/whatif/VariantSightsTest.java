package org.pendant.desktop.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.desktop.scene.ComparedWays;
import org.pendant.recording.replay.Journal;
import org.pendant.recording.replay.ParkedRuns;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.recording.replay.SwitchOn;
import org.pendant.recording.whatif.VariantLimits;
import org.pendant.recording.whatif.VariantOutcome;
import org.pendant.recording.whatif.VariantRun;

final class VariantSightsTest {
  private static final long LAST = 400;

  private final ControllerOptions options = ControllerOptions.headless();
  private final Controller robot = new Controller(options);
  private final Journal journal = Journal.of(robot);

  private VariantSights sights() throws RerunRefused {
    var _ =
        robot.submit(
            new ProgramCommand.StartProgram(
                TestController.program(
                    robot,
                    "def prog():\n  movej([0.5, -1.5, -1.6, -1.6, 1.6, 0], a=2, v=1)\nend\n")));
    for (int i = 0; i < LAST; i++) {
      robot.advance();
    }
    VariantRow slow = VariantRow.AS_IT_RAN.named("slow").withSpeed("50");
    return new VariantSights(
        List.of(VariantRow.AS_IT_RAN, slow, slow.named("not run")),
        List.of(done(VariantRow.AS_IT_RAN), done(slow), new VariantResult.None()),
        1,
        row -> 100 + row);
  }

  private VariantResult done(VariantRow row) throws RerunRefused {
    VariantOutcome outcome =
        VariantRun.fromStart(
                ParkedRuns.none(
                    journal.run(), SwitchOn.of(options, journal.controller().builtins())),
                0,
                row.variant(Optional.empty()),
                VariantLimits.STANDARD)
            .run();
    return new VariantResult.Done(outcome);
  }

  @Test
  void theGhostOfTheRunItselfIsWhereTheArmWasThen() throws RerunRefused {
    VariantSights sights = sights();
    List<ComparedWays.Ghost> ghosts = sights.ghosts(OptionalLong.of(LAST));
    assertEquals(List.of("As it ran", "slow"), ghosts.stream().map(each -> each.name()).toList());
    assertEquals(List.of(100, 101), ghosts.stream().map(each -> each.rgb()).toList());
    assertEquals(List.of(false, true), ghosts.stream().map(each -> each.chosen()).toList());
    double isRad = robot.state().arm().actualPositionRad().get(0);
    assertEquals(isRad, ghosts.get(0).positionRad().get(0), 1e-3);
    assertTrue(ghosts.get(1).positionRad().get(0) < isRad - 0.02);
  }

  @Test
  void whilePeopleLookAtNowThereIsNoGhost() throws RerunRefused {
    VariantSights sights = sights();
    assertEquals(List.of(), sights.ghosts(OptionalLong.empty()));
    assertEquals(2, sights.ways().size());
  }
}
