package org.pendant.recording.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Queue;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.FakeSocket;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ProgramState;

/** A cell of several controllers is repeated as a whole, and stands where it stood, bit for bit. */
@Tag("slow")
final class CellRerunTest {
  private static final int LEFT = 0;
  private static final int RIGHT = 1;
  private static final int PLC = 2;
  private static final long LAST = 1600;

  /** Two arms that push the same boxes, a gripper, wires, a rule, and a script of the cell. */
  private static final String SCENE =
      """
      {
        "objects": [
          {"type": "plane", "name": "floor", "point": [0, 0, 0], "normal": [0, 0, 1]},
          {"type": "box", "name": "box", "pose": [0.5, 0.1, 0.05, 0, 0, 0.1],
           "size": [0.1, 0.1, 0.1], "mass": 0.5},
          {"type": "box", "name": "lid", "pose": [0.5, 0.1, 0.16, 0, 0, 0],
           "size": [0.1, 0.1, 0.02], "mass": 0.1},
          {"type": "sphere", "name": "ball", "centre": [0.6, -0.2, 0.4], "radius": 0.04,
           "mass": 0.2}
        ],
        "arms": [
          {"name": "left", "robot": "ur5e"},
          {"name": "right", "robot": "ur3e", "base": [1, 0, 0, 0, 0, 3.141592653589793]}
        ],
        "script": "plc.script",
        "devices": [
          {"type": "two-finger", "name": "gripper", "controller": "left"},
          {"type": "proximity", "name": "ball there", "signal": "cell.digital_in[1]",
           "at": [0.6, -0.2, 0.04], "range": 0.05}
        ],
        "wires": [["left.digital_out[0]", "cell.digital_in[0]"],
                  ["cell.digital_out[0]", "right.digital_in[0]"]]
      }
      """;

  private static final String LEFT_PROGRAM =
      """
      def left():
        socket_open("127.0.0.1", 63352)
        socket_set_var("POS", 200)
        while True:
          movej([0.3 * random(), -1.1, -2.1, -1.5, 1.57, 0], a=3, v=2)
          set_standard_digital_out(0, not get_standard_digital_out(0))
          movej([-0.4, -1.0 - 0.2 * random(), -2.2, -1.5, 1.57, 0], a=3, v=2)
          textmsg(get_tcp_force())
        end
      end
      """;

  private static final String RIGHT_PROGRAM =
      """
      def right():
        count = 0
        while True:
          if get_standard_digital_in(0):
            movej([0.2 * random(), -1.2, -1.8, -1.6, 1.57, 0], a=3, v=2)
          else:
            movej([-0.3, -1.4, -1.4, -1.6, 1.57, 0], a=3, v=2)
          end
          count = count + 1
        end
      end
      """;

  private static final String PLC_PROGRAM =
      """
      def plc():
        while True:
          set_standard_digital_out(0, get_standard_digital_in(0) and random() > 0.2)
          sleep(0.05)
        end
      end
      """;

  private static CellPlay play() {
    return new CellPlay(SCENE, ControllerOptions.headless().withSeed(5).withMeasuredNoise(true))
        .start(1, LEFT, LEFT_PROGRAM)
        .start(1, RIGHT, RIGHT_PROGRAM)
        .start(30, PLC, PLC_PROGRAM);
  }

  private static CellPlay disturbed() {
    CellPlay play = play();
    SplittableRandom random = new SplittableRandom(19);
    for (long frame = 60; frame < LAST; frame += random.nextInt(10, 80)) {
      int member = random.nextInt(2);
      switch (random.nextInt(4)) {
        case 0 -> play.at(frame, member, new ProgramCommand.PauseProgram());
        case 1 -> play.at(frame, member, new ProgramCommand.ResumeProgram());
        case 2 ->
            play.at(frame, PLC, new IoCommand.SetInput("digital_in[4]", random.nextBoolean()));
        default ->
            play.at(frame, member, new BoxCommand.SetSpeedFraction(random.nextDouble(0.2, 1)));
      }
    }
    return play;
  }

  @Test
  void standsWhereTheOldRunStoodAndGoesOnAsThatDid() throws RerunRefused {
    for (CellPlay play : List.of(play().until(LAST), disturbed().until(LAST))) {
      SplittableRandom random = new SplittableRandom(LAST);
      for (int i = 0; i < 8; i++) {
        long frame = random.nextLong(1, LAST);
        Controllers branch = play.again(frame).controllers();
        String where = "frame " + frame;
        assertEquals(play.frames(frame - 1, frame), List.of(CellPlay.facts(branch)), where);
        long until = Math.min(LAST, frame + 200);
        assertEquals(play.frames(frame, until), play.follow(branch, until), where);
      }
    }
  }

  /** Grippers by XML-RPC, a bar that both arms hold, a sensor: the whole of an example. */
  @Test
  void theHandoverIsRepeatedFromAnyMoment() throws IOException, RerunRefused {
    Path examples = Path.of("../../examples");
    CellPlay play =
        new CellPlay(
            Files.readString(examples.resolve("handover.scene.json")),
            ControllerOptions.headless().withMeasuredNoise(true));
    List<String> names = List.of("handover_left", "handover_right", "handover_cell");
    for (int i = 0; i < names.size(); i++) {
      play.start(1, i, Files.readString(examples.resolve(names.get(i) + ".script")));
    }
    long last = 5000;
    play.until(last);
    assertEquals(
        ProgramState.STOPPED, play.controller(PLC).state().program().state(), "handed over");
    SplittableRandom random = new SplittableRandom(last);
    for (int i = 0; i < 4; i++) {
      long frame = random.nextLong(1000, last);
      Controllers branch = play.again(frame).controllers();
      assertEquals(play.frames(frame, last), play.follow(branch, last), "frame " + frame);
    }
  }

  @Test
  void everyFrameOfTheRerunIsThatOfTheOldRun() throws RerunRefused {
    CellPlay play = disturbed().until(LAST);
    List<List<Object>> again = new ArrayList<>();
    Controllers fresh = play.fresh();
    Rerun.to(LAST, play.journal()).run(fresh, () -> again.add(CellPlay.facts(fresh)));
    assertEquals(play.frames(0, LAST), again);
    ControllerState left = play.controller(LEFT).state();
    assertNotEquals(List.of(), left.moved(), "objects have moved");
  }

  @Test
  void aBranchOfABranchComesOutTheSame() throws RerunRefused {
    CellPlay play = disturbed().until(LAST);
    RunJournal branch = play.again(700);
    List<List<Object>> went = play.follow(branch.controllers(), 900);
    RunJournal second = Rerun.to(900, branch).run(play.fresh(), () -> {});
    assertEquals(went.getLast(), CellPlay.facts(second.controllers()));
  }

  @Test
  void whatIsChangedInTheBranchOfOneArmReachesTheOther() throws RerunRefused {
    CellPlay play = play().until(LAST);
    Controllers branch = play.again(500).controllers();
    var _ = branch.all().get(LEFT).submit(new ProgramCommand.StopProgram());
    play.follow(branch, LAST);
    assertNotEquals(
        play.controller(RIGHT).state().arm().targetPositionRad(),
        branch.all().get(RIGHT).state().arm().targetPositionRad());
  }

  @Test
  void oneThatIsParkedLeadsToTheSame() throws RerunRefused {
    CellPlay play = disturbed().until(LAST);
    Queue<Runnable> background = new ArrayDeque<>();
    ParkedRuns parked =
        new ParkedRuns(play.journal(), play.switchOn(), background::add, new ParkingPlaces(10));
    parked.look(OptionalLong.of(1000));
    while (!background.isEmpty()) {
      background.remove().run();
    }
    Repetition near = parked.before(1000);
    assertEquals(970, near.frame());
    Rerun.to(1000, play.journal()).run(near);
    assertEquals(play.frames(999, 1000), List.of(CellPlay.facts(near.controllers())));
  }

  @Test
  void commandsWhileRobotTimeStandsAreRepeated() throws RerunRefused {
    CellPlay play = play().until(300);
    Controllers all = play.journal().controllers();
    for (int i = 0; i < 3; i++) {
      var _ = all.all().get(i).submit(new IoCommand.SetInput("digital_in[5]", true));
      all.frames().applyCommands();
    }
    var _ = all.all().get(RIGHT).submit(new ProgramCommand.StopProgram());
    all.frames().applyCommands();
    Controllers branch =
        Rerun.to(300, play.journal(), CellPlay.recorded(all))
            .run(play.fresh(), () -> {})
            .controllers();
    assertEquals(CellPlay.facts(all), CellPlay.facts(branch));
  }

  private static void ask(Controller controller, Consumer<Debugger> request) {
    var _ = controller.submit(new DebugCommand.Debug(request));
  }

  /** Pauses the programs of one after the other while commands come to all of them. */
  @Test
  void aRerunMakesTheSameStopsOfAnyProgram() throws RerunRefused {
    CellPlay play = play();
    Controllers all = play.journal().controllers();
    for (int line : new int[] {6, 8}) {
      ask(all.all().get(RIGHT), debugger -> debugger.set(Breakpoint.at(line)));
      ask(all.all().get(LEFT), debugger -> debugger.set(Breakpoint.at(line)));
    }
    ask(all.all().get(PLC), debugger -> debugger.set(Breakpoint.at(4).when("random() > 0.9")));
    SplittableRandom random = new SplittableRandom(29);
    List<List<Object>> was = new ArrayList<>();
    int stops = 0;
    play.until(1);
    was.add(CellPlay.facts(all));
    while (all.frame() < 1200 || all.frames().held()) {
      if (all.frames().held()) {
        stops++;
        Controller other = all.all().get(random.nextInt(3));
        var _ = other.submit(new IoCommand.SetInput("digital_in[6]", random.nextBoolean()));
        if (random.nextInt(3) > 0) {
          all.all().stream()
              .filter(Controller::held)
              .forEach(
                  each ->
                      ask(
                          each,
                          random.nextBoolean()
                              ? Debugger::resume
                              : debugger -> debugger.stepOver(Debugger.MAIN)));
        }
        all.frames().applyCommands();
      } else if (random.nextInt(60) == 0) {
        // they have come too late for this frame
        var _ =
            all.all()
                .get(LEFT)
                .submit(new IoCommand.SetInput("digital_in[7]", random.nextBoolean()));
        all.frames().advanceBeforeCommands();
      } else {
        all.frames().advance();
      }
      was.add(CellPlay.facts(all));
    }
    assertTrue(stops > 20, stops + " stops");
    assertEquals(ProgramState.RUNNING, play.controller(RIGHT).state().program().state());
    List<List<Object>> is = new ArrayList<>();
    Controllers fresh = play.fresh();
    Rerun.to(1200, play.journal(), CellPlay.recorded(all))
        .run(fresh, () -> is.add(CellPlay.facts(fresh)));
    assertEquals(was, is);
  }

  @Test
  void aFrameThatIsStillHeldIsHeldInTheBranchToo() throws RerunRefused {
    CellPlay play = play();
    Controllers all = play.journal().controllers();
    ask(all.all().get(RIGHT), debugger -> debugger.set(Breakpoint.at(6)));
    play.until(1);
    while (!all.frames().held()) {
      all.frames().advance();
    }
    var _ = all.all().get(PLC).submit(new IoCommand.SetInput("digital_in[5]", true));
    all.frames().applyCommands();
    RunJournal branch =
        Rerun.to(all.frame(), play.journal(), CellPlay.recorded(all)).run(play.fresh(), () -> {});
    assertTrue(branch.controllers().frames().held());
    assertEquals(CellPlay.facts(all), CellPlay.facts(branch.controllers()));
    for (Controllers each : List.of(all, branch.controllers())) {
      ask(each.all().get(RIGHT), Debugger::resume);
      for (int i = 0; i < 30; i++) {
        each.frames().advance();
      }
    }
    assertEquals(CellPlay.facts(all), CellPlay.facts(branch.controllers()));
  }

  @Test
  void whatOneControllerHasGotFromOutsideEndsWhatCanBeRepeatedAndIsTold() throws RerunRefused {
    ControllerOptions options =
        ControllerOptions.headless()
            .withOutside(new Connectors((host, port) -> new FakeSocket(), Connectors.NONE.rpc()));
    CellPlay play =
        new CellPlay(SCENE, options)
            .start(1, LEFT, LEFT_PROGRAM)
            .start(51, RIGHT, "def f():\n  socket_open(\"peer\", 4000)\nend\n")
            .until(100);
    assertEquals(
        Optional.of(
            "only what was before 0.102 s can be run again: then right: a program connected a"
                + " socket to peer:4000, which may come out otherwise the next time"),
        play.journal().refusal(60));
    assertFalse(play.journal().refusal(50).isPresent());
    assertEquals(50, play.again(50).controllers().frame());
  }

  @Test
  void aSnapshotOfAnyControllerThatIsNotOfThisRunIsToldFromIt() {
    CellPlay play = play().until(100);
    CellPlay other = play().until(40).at(41, RIGHT, new ProgramCommand.PauseProgram()).until(100);
    Controllers fresh = play.fresh();
    RerunRefused refused =
        assertThrows(
            RerunRefused.class,
            () ->
                Rerun.to(100, play.journal(), CellPlay.recorded(other.journal().controllers()))
                    .run(fresh, () -> {}));
    assertTrue(
        refused.getMessage().startsWith("the run came out otherwise at 0.200 s: right: the target"),
        refused.getMessage());
  }
}
