package org.pendant.recording.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.List;
import java.util.OptionalLong;
import java.util.Queue;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.state.ControllerState;

/** Runs that are parked stand where the run stood, to the bit, and are as many as they may be. */
final class ParkedRunsTest {
  /** A second, as far as places are concerned: of 10 frames, so that runs are short. */
  private static final long S = 10;

  private static final long LAST = 130 * S;

  private static final String NAPS =
      """
      def prog():
        count = 0
        thread beside():
          while True:
            count = count + random()
            sleep(0.07)
          end
        end
        run beside()
        while True:
          movej([0.2 * random(), -1.5, -1.6, -1.6, 1.6, 0], a=9, v=3)
          set_standard_digital_out(2, count > 20)
          sleep(0.1 + random())
        end
      end
      """;

  private final Queue<Runnable> background = new ArrayDeque<>();

  private static Play play(long until) {
    Play play = new Play(ControllerOptions.headless().withSeed(3)).start(NAPS);
    for (long frame = 30; frame < until; frame += 77) {
      play.at(frame, new IoCommand.SetInput("digital_in[0]", frame % 2 == 0));
    }
    return play.until(until);
  }

  private ParkedRuns parked(Play play) {
    return new ParkedRuns(
        play.journal.run(), play.switchOn(), background::add, new ParkingPlaces(S));
  }

  private void work() {
    while (!background.isEmpty()) {
      background.remove().run();
    }
  }

  @Test
  void whatGoesOnFromAParkedRunEqualsWhatGoesOnFromTheSwitchOn() throws RerunRefused {
    Play play = play(LAST);
    ParkedRuns parked = parked(play);
    long moment = 50 * S + 7;
    parked.look(OptionalLong.of(moment));
    work();
    assertEquals(List.of(moment - 3 * S, 60 * S), parked.frames());
    Repetition near = parked.before(moment);
    assertEquals(moment - 3 * S, near.frame());
    Rerun rerun = Rerun.to(moment, play.journal.run());
    Journal branch = rerun.run(near).of(0);
    assertEquals(
        play.frames.get((int) moment - 1), Play.facts(near.controllers().all().getFirst().state()));
    ControllerState old = play.again(moment).controller().state();
    assertEquals(Play.facts(old), Play.facts(near.controllers().all().getFirst().state()));
    assertEquals(
        play.frames.subList((int) moment, (int) moment + 400),
        play.follow(near.controllers().all().getFirst(), moment + 400));
    // its journal is whole: a branch of the branch comes out the same
    ControllerState second =
        Play.again(Rerun.to(moment + 300, branch.run()), play.options).controller().state();
    assertEquals(play.frames.get((int) moment + 299), Play.facts(second));
  }

  @Test
  void withoutOneBeforeTheMomentTheWayGoesFromTheSwitchOn() {
    Play play = play(LAST);
    ParkedRuns parked = parked(play);
    assertEquals(0, parked.before(LAST).frame());
    parked.follow();
    work();
    assertEquals(List.of(60 * S), parked.frames());
    assertEquals(0, parked.before(60 * S).frame());
    assertEquals(60 * S, parked.before(60 * S + 1).frame());
    assertEquals(List.of(), parked.frames());
  }

  @Test
  void twoThatWantTheSameMomentGetOneEach() {
    Play play = play(LAST);
    ParkedRuns parked = parked(play);
    parked.look(OptionalLong.of(LAST));
    work();
    Repetition first = parked.before(LAST);
    Repetition second = parked.before(LAST);
    assertNotSame(first, second);
    assertEquals(List.of(LAST - 3 * S, LAST - 40 * S), List.of(first.frame(), second.frame()));
  }

  @Test
  void theyStandAllAlongWhatIsRecordedAndGoOnWithIt() {
    Play play = play(125 * S);
    ParkedRuns parked = parked(play);
    parked.follow();
    work();
    assertEquals(List.of(60 * S), parked.frames());
    play.until(260 * S);
    parked.follow();
    work();
    assertEquals(List.of(60 * S, 120 * S, 180 * S, 240 * S), parked.frames());
    play.until(330 * S);
    parked.follow(200 * S);
    work();
    assertEquals(List.of(180 * S, 240 * S, 300 * S), parked.frames().subList(1, 4));
  }

  @Test
  void nothingIsParkedWhereTheRunCannotBeRepeated() {
    Play play = new Play(ControllerOptions.headless().withSystemTime(() -> Instant.EPOCH));
    play.start("def prog():\n  t = time(2)\n  sleep(500)\nend\n").until(LAST);
    ParkedRuns parked = parked(play);
    parked.look(OptionalLong.of(LAST));
    work();
    assertEquals(List.of(), parked.frames());
  }

  @Test
  void oneThatComesOutOtherwiseEndsThemAll() {
    Play play = play(LAST);
    ParkedRuns parked =
        new ParkedRuns(
            play.journal.run(),
            SwitchOn.of(play.options.withSeed(4), play.controller().builtins()),
            background::add);
    parked.follow();
    work();
    assertEquals(List.of(), parked.frames());
    parked.look(OptionalLong.of(90 * S));
    assertEquals(List.of(), List.copyOf(background));
    assertThrows(
        RerunRefused.class, () -> Rerun.to(LAST, play.journal.run()).run(parked.before(LAST)));
  }

  @Test
  void programsWithLargeValuesHaveFewer() {
    Play play = new Play(ControllerOptions.headless());
    play.start(
            """
            def prog():
              m = make_list(1000000, 1.5)
              n = make_list(1000000, 1.5)
              o = make_list(1000000, 1.5)
              sleep(500)
            end
            """)
        .until(LAST);
    ParkedRuns parked = parked(play);
    parked.look(OptionalLong.of(90 * S));
    work();
    assertEquals(2, parked.frames().size());
  }

  @Test
  void closedItKeepsNone() {
    Play play = play(LAST);
    ParkedRuns parked = parked(play);
    parked.follow();
    parked.close();
    work();
    assertEquals(List.of(), parked.frames());
    parked.look(OptionalLong.of(100 * S));
    assertEquals(List.of(), List.copyOf(background));
    assertEquals(0, parked.before(100 * S).frame());
  }

  @Test
  void commandsWhileRobotTimeStandsAreRepeated() throws RerunRefused {
    Play play = play(LAST);
    ParkedRuns parked = parked(play);
    parked.follow();
    work();
    for (int i = 0; i < 3; i++) {
      var _ = play.controller().submit(new IoCommand.SetInput("digital_in[" + (i + 1) + "]", true));
      play.controller().applyCommands();
    }
    Repetition near = parked.before(LAST);
    play.to(play.controller().state()).run(near);
    assertEquals(play.controller().state().io(), near.controllers().all().getFirst().state().io());
    var _ = play.controller().submit(new ProgramCommand.StopProgram());
    play.controller().applyCommands();
    parked.look(OptionalLong.of(LAST));
    work();
    Repetition late = parked.before(LAST);
    play.to(play.controller().state()).run(late);
    assertEquals(
        play.controller().state().program().state(),
        late.controllers().all().getFirst().state().program().state());
  }
}
