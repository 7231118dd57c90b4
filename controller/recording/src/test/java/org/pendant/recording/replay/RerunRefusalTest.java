package org.pendant.recording.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.FakeModbus;
import org.pendant.controller.external.FakeServer;
import org.pendant.controller.external.FakeSocket;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.external.ToolSerialConnector;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.Program;

/** What cannot be repeated is refused with its reason; what was before still can. */
@Tag("slow")
final class RerunRefusalTest {
  private static final ControllerOptions REAL_TIME =
      ControllerOptions.headless().withSystemTime(() -> Instant.EPOCH);

  private static String refusal(Play play, long frame) {
    String why =
        assertThrows(RerunRefused.class, () -> Rerun.to(frame, play.journal.run())).getMessage();
    assertEquals(Optional.of(why), play.journal.run().refusal(frame));
    return why;
  }

  private static void repeats(Play play, long frame) throws RerunRefused {
    Controller branch = play.again(frame).controller();
    assertEquals(frame, branch.state().frame());
    assertEquals(Optional.empty(), branch.determinism().loss());
  }

  private static long lost(Play play) {
    return play.controller().determinism().loss().orElseThrow().frame();
  }

  @Test
  void framesThatAreNotThere() throws RerunRefused {
    Play play = new Play(ControllerOptions.headless()).until(10);
    assertEquals("frame is 11, must be 0 to 10", refusal(play, 11));
    assertEquals("frame is -1, must be 0 to 10", refusal(play, -1));
    repeats(play, 10);
  }

  @Test
  void aSocketEndsWhatCanBeRepeated() throws RerunRefused {
    ControllerOptions options =
        ControllerOptions.headless()
            .withOutside(new Connectors((host, port) -> new FakeSocket(), Connectors.NONE.rpc()));
    Play play =
        new Play(options)
            .start("def f():\n  sleep(0.1)\n  socket_open(\"peer\", 4000)\nend\n")
            .until(80);
    long frame = lost(play);
    assertEquals(
        "only what was before 0.102 s can be run again: then a program connected a socket to"
            + " peer:4000, which may come out otherwise the next time",
        refusal(play, frame));
    repeats(play, frame - 1);
  }

  @Test
  void aWayOutThatThereIsNotCanBeRepeated() throws RerunRefused {
    Play play =
        new Play(ControllerOptions.headless())
            .start("def f():\n  socket_open(\"peer\", 4000)\nend\n")
            .until(20);
    repeats(play, 20);
  }

  @Test
  void aDeviceOutsideEndsIt() {
    ControllerOptions options =
        ControllerOptions.headless()
            .withOutside(
                new Connectors(Connectors.NONE.sockets(), Connectors.NONE.rpc(), new FakeModbus()));
    Play play =
        new Play(options)
            .start("def f():\n  modbus_add_signal(\"10.0.0.1\", 1, 3, 0, \"tank\")\nend\n");
    assertTrue(refusal(play.until(20), 20).contains("Modbus signal was added at 10.0.0.1:502"));
  }

  @Test
  void aToolpathThatIsWaitedForEndsItInRealTimeOnly(@TempDir Path folder)
      throws IOException, RerunRefused {
    Files.writeString(folder.resolve("path.nc"), "G01 X0 Y0 Z0 F100\nX5\n");
    String text =
        """
        def f():
          tcp = p[0, 0, 0.1, 3.14159265358979, 0, 0]
          mc_initialize(0, tcp, doc=6)
          mc_set_pcs(pose_trans(get_actual_tcp_pose(), tcp))
          path = mc_load_path("path.nc", False)
          mc_run_motion(mc_add_path(path, 1, 0.1, 0))
        end
        """;
    for (ControllerOptions options : List.of(ControllerOptions.headless(), REAL_TIME)) {
      Play play =
          new Play(options.withProgramsFolder(ProgramsFolder.at(folder))).start(text).until(100);
      if (options.equals(REAL_TIME)) {
        assertTrue(refusal(play, 100).contains("until a toolpath was planned"));
        repeats(play, lost(play) - 1);
      } else {
        repeats(play, 100);
      }
    }
  }

  @Test
  void remoteProceduresEndIt() {
    ControllerOptions options =
        ControllerOptions.headless()
            .withOutside(new Connectors(Connectors.NONE.sockets(), url -> new FakeServer()));
    Play play =
        new Play(options).start("def f():\n  s = rpc_factory(\"xmlrpc\", \"http://a:1\")\nend\n");
    assertTrue(refusal(play.until(20), 20).contains("remote procedures at http://a:1"));
  }

  @Test
  void theDateEndsItInRealTimeOnly() throws RerunRefused {
    String text = "def f():\n  sleep(0.1)\n  textmsg(time(2))\nend\n";
    repeats(new Play(ControllerOptions.headless()).start(text).until(80), 80);
    Play play = new Play(REAL_TIME).start(text).until(80);
    assertTrue(refusal(play, 80).contains("then a program asked for the date"), refusal(play, 80));
    repeats(play, lost(play) - 1);
  }

  @Test
  void theLoadOfTheComputerEndsIt() {
    Play play =
        new Play(REAL_TIME)
            .start("def f():\n  textmsg(get_rtde_value(\"actual_execution_time\"))\nend\n")
            .until(20);
    assertTrue(refusal(play, 20).contains("how long the computer works at a frame"));
  }

  @Test
  void aProgramInRealTimeThatAsksForNoneOfThisCanBeRepeated() throws RerunRefused {
    Play play =
        new Play(REAL_TIME)
            .start("def f():\n  movej([0, -1.4, -1.6, -1.6, 1.6, 0])\n  textmsg(time(0))\nend\n")
            .until(1000);
    Controller branch = play.again(700).controller();
    assertEquals(play.frames.get(699), Play.facts(branch.state()));
    assertEquals(play.frames.subList(700, 1000), play.follow(branch, 1000));
  }

  @Test
  void theSerialLineOfTheToolEndsItOnceItIsOn() throws RerunRefused {
    ToolSerialConnector door =
        new ToolSerialConnector() {
          @Override
          public SetUp setUp(ToolCommunication wanted) {
            return () -> false;
          }

          @Override
          public List<News> takeNews() {
            return List.of();
          }
        };
    ControllerOptions options =
        ControllerOptions.headless().withOutside(Connectors.NONE.withToolSerial(door));
    String off = "set_tool_communication(False, 115200, 0, 1, 1.5, 3.5)\n";
    Play harmless = new Play(options).start("def f():\n" + off + "end\n").until(20);
    repeats(harmless, 20);
    Play play =
        new Play(options).start("def f():\n" + off + off.replace("False", "True") + "end\n");
    assertTrue(refusal(play.until(20), 20).contains("serial line of the tool"));
  }

  @Test
  void aFullJournalRefusesWhatComesAfter() throws RerunRefused {
    Play play = new Play(ControllerOptions.headless(), new JournalLimits(3, 1 << 20));
    for (int frame = 10; frame <= 50; frame += 10) {
      play.at(frame, new IoCommand.SetInput("digital_in[0]", frame % 20 == 0));
    }
    play.until(60);
    assertEquals(3, play.journal.run().size());
    assertEquals(
        "only what was before 0.080 s can be run again: then there were more commands than are"
            + " kept, 3 or 1 MB",
        refusal(play, 40));
    repeats(play, 39);
  }

  @Test
  void aFullJournalDoesNotKnowWhichProgramWasStartedLast() {
    Play play = new Play(ControllerOptions.headless(), new JournalLimits(1, 1 << 20));
    Program first = play.program("def first():\n  sleep(0.01)\nend\n");
    play.at(1, new ProgramCommand.StartProgram(first)).until(20);
    assertEquals("first", play.journal.newestProgram().orElseThrow().name());
    Program second = play.program("def second():\n  sleep(0.01)\nend\n");
    play.at(30, new ProgramCommand.StartProgram(second)).until(40);
    assertEquals(Optional.empty(), play.journal.newestProgram());
  }

  @Test
  void largeCommandsFillIt() throws RerunRefused {
    Play play = new Play(ControllerOptions.headless(), new JournalLimits(1000, 10_000));
    String large = "def f():\n" + "  textmsg(1)\n".repeat(100) + "end\n";
    play.start(large).until(10);
    assertEquals(0, play.journal.run().size());
    repeats(play, 0);
    assertTrue(refusal(play, 1).contains("more commands than are kept"));
  }

  @Test
  void otherOptionsComeOutOtherwise() {
    Play play =
        new Play(ControllerOptions.headless())
            .at(20, new IoCommand.SetInput("digital_in[0]", true))
            .until(30);
    ControllerOptions other = play.options.withStart(new Joints(0.1, -1.5, -1.6, -1.6, 1.6, 0));
    String why =
        assertThrows(RerunRefused.class, () -> Play.again(Rerun.to(25, play.journal.run()), other))
            .getMessage();
    assertEquals(
        "the run came out otherwise at 0.038 s: arm, signals or program were not as before", why);
  }

  @Test
  void aSnapshotThatIsNotOfThisRunIsToldFromIt() throws RerunRefused {
    Play play = new Play(ControllerOptions.headless()).until(30);
    ControllerState mine = play.controller().state();
    assertEquals(30, play.again(mine).controller().state().frame());
    ControllerState other =
        new Play(ControllerOptions.headless().withStart(new Joints(0.1, -1.5, -1.6, -1.6, 1.6, 0)))
            .until(30)
            .controller()
            .state();
    String why = assertThrows(RerunRefused.class, () -> play.again(other)).getMessage();
    assertTrue(why.startsWith("the run came out otherwise at 0.060 s: the target position"), why);
  }

  @Test
  void aFileThatHasChangedIsNoticed(@TempDir Path folder) throws IOException, RerunRefused {
    Path file = folder.resolve("path.nc");
    Files.writeString(file, "G01 X0 Y0 Z0 F100\nX5\n");
    Play play =
        new Play(ControllerOptions.headless().withProgramsFolder(ProgramsFolder.at(folder)))
            .start(
                """
                def f():
                  mc_initialize(0, p[0, 0, 0.1, 0, 0, 0])
                  mc_load_path("path.nc", False)
                  sleep(1)
                end
                """)
            .until(100);
    assertEquals(1, play.controller().determinism().files().size());
    repeats(play, 100);
    Files.writeString(file, "G01 X0 Y0 Z0 F100\nX6\n");
    String why = assertThrows(RerunRefused.class, () -> play.again(100)).getMessage();
    assertTrue(why.endsWith("the file path.nc has changed"), why);
  }

  @Test
  void aCancelledRerunEnds() throws RerunRefused {
    Play play = new Play(ControllerOptions.headless()).until(100);
    Rerun rerun = Rerun.to(100, play.journal.run());
    Controller fresh = new Controller(play.options);
    assertEquals(0, rerun.progress());
    assertThrows(
        CancellationException.class,
        () ->
            rerun.run(
                Controllers.of(fresh),
                () -> {
                  if (fresh.state().frame() == 50) {
                    rerun.cancel();
                  }
                }));
    assertEquals(0.5, rerun.progress());
  }

  @Test
  void aControllerThatHasRunIsTooLateForAJournal() {
    Controller controller = new Controller(ControllerOptions.headless());
    controller.advance();
    assertThrows(IllegalArgumentException.class, () -> Journal.of(controller));
  }

  @Test
  void theProgramThatWasStartedLastIsKnown() {
    Play play = new Play(ControllerOptions.headless());
    assertEquals(Optional.empty(), play.journal.newestProgram());
    play.start("def first():\n  sleep(0.01)\nend\n").until(20);
    play.at(
            30,
            new ProgramCommand.StartProgram(play.program("def second():\n  sleep(0.01)\nend\n")))
        .until(40);
    assertEquals("second", play.journal.newestProgram().orElseThrow().name());
  }

  @Test
  void thoseWhoHaveTakenSignalsAreKnown() {
    Play play =
        new Play(ControllerOptions.headless())
            .at(1, new IoCommand.ClaimSignal("one", "input_float_register[3]"))
            .at(1, new IoCommand.ClaimSignal("two", "input_float_register[4]"))
            .at(5, new IoCommand.ReleaseSignals("one"))
            .until(10);
    assertEquals(Set.of("two"), play.journal.owners());
    assertFalse(play.journal.run().refusal(10).isPresent());
  }
}
