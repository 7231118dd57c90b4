package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Reply;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.controller.external.FakeSocket;
import org.pendant.language.source.Source;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;

class SocketProgramTest {
  private final List<FakeSocket> sockets = new ArrayList<>();
  private final RunningProgram program =
      new RunningProgram(
          ControllerOptions.headless()
              .withOutside(new Connectors((host, port) -> open(), Connectors.NONE.rpc())));

  private FakeSocket open() {
    FakeSocket socket = new FakeSocket();
    sockets.add(socket);
    return socket;
  }

  /** Starts a program whose first line has opened a socket. */
  private FakeSocket connected(String lines) {
    program.start("def f():\n  socket_open(\"peer\", 4000)\n" + lines + "end\n");
    program.advance(1);
    sockets.getFirst().accept();
    program.advance(1);
    return sockets.getFirst();
  }

  @Test
  void opensWhenThePeerAccepts() {
    program.start("def f():\n  textmsg(socket_open(\"peer\", 4000))\nend\n");
    program.advance(10);
    assertEquals(List.of(), program.said());
    sockets.getFirst().accept();
    program.finish();
    assertEquals(List.of("True"), program.said());
  }

  @Test
  void isFalseWhenThePeerRefusesAndSaysWhyInTheLog() {
    program.start("def f():\n  textmsg(socket_open(\"peer\", 4000))\nend\n");
    program.advance(2);
    sockets.getFirst().refuse("connection refused");
    program.finish();
    assertEquals(List.of("False"), program.said());
    assertEquals(
        List.of("socket_open: \"peer\", port 4000: connection refused"), program.reported());
  }

  @Test
  void opensForTwoSecondsOnly() {
    program.start("def f():\n  textmsg(socket_open(\"peer\", 4000))\nend\n");
    program.advance(999);
    assertEquals(ProgramState.RUNNING, program.programState());
    program.advance(2);
    assertEquals(List.of("False"), program.said());
    assertEquals(ExternalSocket.Stage.CLOSED, sockets.getFirst().stage());
  }

  @Test
  void aReadTakesUntilItsBytesAreThere() {
    FakeSocket peer = connected("  textmsg(socket_read_byte_list(3))\n");
    peer.say("ab");
    program.advance(20);
    assertEquals(List.of(), program.said());
    peer.say("c");
    program.finish();
    assertEquals(List.of("[3, 97, 98, 99]"), program.said());
  }

  @Test
  void readsOfDataThatAreThereTakeNoFrame() {
    FakeSocket peer =
        connected(
            """
              sleep(0.002)
              i = 0
              while i < 200:
                i = i + socket_read_binary_integer(1)[0]
              end
              textmsg(i, socket_read_ascii_float(2))
              textmsg(socket_read_line(), socket_read_string(prefix="<", suffix=">"))
              textmsg(socket_read_byte_list(1), socket_read_string())
            """);
    peer.say("\0\0\0\1".repeat(200) + "(1.5, 2)line\n<text>Arest");
    program.advance(2);
    assertEquals(List.of("200[2, 1.5, 2]", "linetext", "[1, 65]rest"), program.said());
  }

  @Test
  void manyReadsAreBoundedByTheComputingTimeOfAFrame() {
    FakeSocket peer =
        connected(
            """
              sleep(0.002)
              i = 0
              while i < 20000:
                i = i + socket_read_byte_list(1)[0]
                if i % 1000 == 0:
                  textmsg(i)
                end
              end
            """);
    peer.say("a".repeat(20_000));
    program.advance(3);
    int early = program.said().size();
    assertTrue(early < 5, () -> early + " thousand reads in two frames");
    program.finish();
    assertEquals(20, program.said().size());
  }

  @Test
  void aReadThatFailsTakesItsFrame() {
    FakeSocket peer =
        connected(
            """
              while True:
                textmsg(socket_read_string())
              end
            """);
    peer.reset();
    program.advance(10);
    assertEquals(10, program.said().size());
  }

  @Test
  void whatStandsBehindAStopAtRestIsSentThoughTheThreadIsKilledInThatFrame() {
    FakeSocket peer =
        connected(
            """
              thread worker():
                socket_read_byte_list(1)
                stopj(2)
                socket_send_byte(33)
                sync()
                socket_send_byte(63)
              end
              thread killer():
                socket_read_byte_list(1)
                kill w
              end
              w = run worker()
              k = run killer()
              join k
            """);
    program.advance(2);
    peer.say("ab");
    program.finish();
    assertEquals("!", peer.heard());
  }

  @Test
  void aReadWaitsAsLongAsItsTimeoutAndKeepsWhatThereIs() {
    FakeSocket peer =
        connected(
            """
              textmsg(socket_read_binary_integer(1, timeout=0.1))
              textmsg(socket_read_binary_integer(1))
            """);
    peer.say("\0\0");
    program.advance(49);
    assertEquals(List.of(), program.said());
    program.advance(2);
    assertEquals(List.of("[0, -1]"), program.said());
    peer.say("\1\0");
    program.finish();
    assertEquals(List.of("[0, -1]", "[1, 256]"), program.said());
  }

  @Test
  void aTimeoutOfZeroOrLessWaitsForEverUntilTheProgramStops() {
    connected("  socket_read_string(timeout=0)\n");
    program.advance(5000);
    assertEquals(ProgramState.RUNNING, program.programState());
    program.done(new ProgramCommand.StopProgram());
    assertEquals(ProgramState.STOPPED, program.programState());
    assertEquals(ExternalSocket.Stage.CLOSED, sockets.getFirst().stage());
  }

  @Test
  void aReadFailsAtOnceWhenNothingCanComeAnyMore() {
    FakeSocket peer =
        connected(
            """
              textmsg(socket_read_string(suffix=";", timeout=-1))
              textmsg(socket_read_string(suffix=";", timeout=-1))
              textmsg(socket_send_byte(33))
            """);
    peer.say("last;half");
    peer.endSending();
    program.finish();
    assertEquals(List.of("last", "", "True"), program.said());
    assertEquals("!", peer.heard());
  }

  @Test
  void sendsNumbersAndTextsAsBytes() {
    FakeSocket peer =
        connected(
            """
              textmsg(socket_send_byte(200))
              socket_send_int(-2)
              socket_send_line("line")
              socket_send_string("text\u00e9")
              socket_send_string(1.5)
              socket_send_line([1, 2])
              socket_set_var("POS_Y", 2200)
            """);
    program.finish();
    assertEquals(List.of("True"), program.said());
    assertEquals(
        "\u00c8\u00ff\u00ff\u00ff\u00feline\ntext\u00e91.5[1, 2]\nSET POS_Y 2200\n", peer.heard());
  }

  @Test
  void asksForAVariableAndTakesItsLine() {
    FakeSocket peer = connected("  textmsg(socket_get_var(\"POS_X\"))\n");
    program.advance(3);
    assertEquals("GET POS_X\n", peer.heard());
    peer.say("POS_X 17\n");
    program.finish();
    assertEquals(List.of("17"), program.said());
  }

  @Test
  void aVariableThatDoesNotComeIsZeroAfterTwoSeconds() {
    connected("  textmsg(socket_get_var(\"POS_X\"))\n");
    program.advance(990);
    assertEquals(List.of(), program.said());
    program.advance(20);
    assertEquals(List.of("0"), program.said());
  }

  @Test
  void escapesInPrefixAndSuffixAreInterpretedOnDemandAndLeadingBlanksDropped() {
    FakeSocket peer =
        connected(
            """
              textmsg(socket_read_string(prefix="  >", suffix="\\r\\n", interpret_escape=True))
              textmsg(socket_read_string(suffix="\\n"))
            """);
    peer.say("x>one\r\ntwo\nthree\\n");
    program.finish();
    assertEquals(List.of("one", "two\nthree"), program.said());
  }

  @Test
  void whatIsNotOpenFailsWithoutAnError() {
    program.run(
        """
        def f():
          textmsg(socket_send_string("x"))
          textmsg(socket_read_string())
          textmsg(socket_read_ascii_float(2))
          textmsg(socket_get_var("x"))
          socket_send_line("y")
          socket_close("never")
        end
        """);
    assertEquals(List.of("False", "", "[0, nan, nan]", "0"), program.said());
    assertEquals(
        List.of(
            "socket_send_string: socket \"socket_0\" is not open",
            "socket_read_string: socket \"socket_0\" is not open",
            "socket_read_ascii_float: socket \"socket_0\" is not open",
            "socket_get_var: socket \"socket_0\" is not open",
            "socket_send_line: socket \"socket_0\" is not open"),
        program.reported());
  }

  @Test
  void threadsUseDifferentSocketsAndTheSameOne() {
    FakeSocket first =
        connected(
            """
              thread other():
                socket_open("peer", 4001, "second")
                textmsg(socket_read_line("second", 0))
              end
              thread same():
                textmsg(socket_read_line(timeout=0))
              end
              a = run other()
              b = run same()
              textmsg(socket_read_line(timeout=0))
              join a
              join b
            """);
    program.advance(2);
    sockets.get(1).accept();
    program.advance(1);
    sockets.get(1).say("second\n");
    program.advance(1);
    first.say("a\nb\n");
    program.finish();
    assertEquals(
        List.of("second", "a", "b"), program.said().stream().sorted(this::inOrder).toList());
  }

  /** Which of two threads reads first is the scheduler's business. */
  private int inOrder(String a, String b) {
    return a.equals("second") ? -1 : b.equals("second") ? 1 : a.compareTo(b);
  }

  @Test
  void openingANameAgainClosesTheFirstSocket() {
    FakeSocket first = connected("  socket_open(\"peer\", 4001)\n");
    program.advance(2);
    assertEquals(ExternalSocket.Stage.CLOSED, first.stage());
    assertEquals(ExternalSocket.Stage.CONNECTING, sockets.get(1).stage());
  }

  @Test
  void closingEndsTheReadOfAnotherThread() {
    connected(
        """
          thread reader():
            textmsg("read ", socket_read_string(timeout=0))
          end
          r = run reader()
          sync()
          socket_close()
          join r
        """);
    program.finish();
    assertEquals(List.of("read "), program.said());
  }

  @Test
  void killingAThreadThatConnectsClosesItsSocket() {
    program.run(
        """
        def f():
          thread opener():
            socket_open("peer", 4000)
          end
          o = run opener()
          sync()
          kill o
        end
        """);
    assertEquals(ExternalSocket.Stage.CLOSED, sockets.getFirst().stage());
  }

  @Test
  void pausesOutlastTimeouts() {
    FakeSocket peer = connected("  textmsg(socket_read_byte_list(1, timeout=0.1))\n");
    program.advance(10);
    program.done(new ProgramCommand.PauseProgram());
    program.advance(500);
    program.done(new ProgramCommand.ResumeProgram());
    program.advance(5);
    peer.say("a");
    program.finish();
    assertEquals(List.of("[1, 97]"), program.said());
  }

  @Test
  void saysWhetherAThreadWaitsForTheOutside() {
    Controller controller =
        new Controller(
            ControllerOptions.headless()
                .withOutside(new Connectors((host, port) -> open(), Connectors.NONE.rpc())));
    LoadResult loadResult =
        controller.load(
            Source.of(
                "t.script",
                "def f():\n  sleep(0.01)\n  socket_open(\"peer\", 1)\n  sleep(1)\nend\n"
                    .getBytes(StandardCharsets.ISO_8859_1)));
    var _ = controller.submit(new ProgramCommand.StartProgram(loadResult.program().orElseThrow()));
    controller.advance();
    assertFalse(controller.waitsForOutside());
    assertTrue(controller.runUntil(controller::waitsForOutside, 20));
    sockets.getFirst().accept();
    controller.advance();
    assertFalse(controller.waitsForOutside());
  }

  @Test
  void aSecondaryProgramMaySendOnce() {
    FakeSocket peer = connected("  sleep(1)\n");
    program.done(
        new ProgramCommand.RunSecondary(program.program("sec s():\n socket_send_byte(65)\nend\n")));
    assertEquals("A", peer.heard());
    Reply.Failed failed =
        assertInstanceOf(
            Reply.Failed.class,
            program.ask(
                new ProgramCommand.RunSecondary(
                    program.program(
                        "sec s():\n socket_send_byte(66)\n socket_send_byte(67)\nend\n"))));
    assertTrue(
        failed.failure().message().contains("Runtime is too much behind"),
        failed.failure().message());
    assertEquals("AB", peer.heard());
    assertEquals(ProgramState.RUNNING, program.programState());
  }

  @Test
  void aSecondaryProgramCannotRead() {
    LoadResult loadResult =
        new Controller(ControllerOptions.headless())
            .load(
                Source.of(
                    "t.script",
                    "sec s():\n socket_read_string()\nend\n"
                        .getBytes(StandardCharsets.ISO_8859_1)));
    assertTrue(loadResult.program().isEmpty());
    assertTrue(
        loadResult.diagnostics().toString().contains("takes robot time"),
        loadResult.diagnostics()::toString);
  }

  @Test
  void refusesWhatCannotBe() {
    refuses("socket_open(\"peer\", 0)", "socket_open: port is 0, must be 1 to 65535");
    refuses("socket_open(\"peer\", 70000)", "socket_open: port is 70000, must be 1 to 65535");
    refuses("socket_send_byte(256)", "socket_send_byte: value is 256, must be 0 to 255");
    refuses("socket_send_int(1.5)", "socket_send_int: value is float 1.5, must be an int");
    refuses(
        "socket_read_ascii_float(31)", "socket_read_ascii_float: number is 31, must be 1 to 30");
    refuses("socket_read_byte_list(0)", "socket_read_byte_list: number is 0, must be 1 to 30");
  }

  private void refuses(String call, String message) {
    program.run("def f():\n  " + call + "\nend\n");
    assertTrue(program.reported().getLast().endsWith(message), () -> program.reported().getLast());
  }

  @Test
  void aControllerWithoutDoorsRefusesClearly() {
    RunningProgram alone = new RunningProgram();
    alone.run("def f():\n  socket_open(\"peer\", 4000)\nend\n");
    assertTrue(
        alone
            .reported()
            .getLast()
            .endsWith("socket_open: this controller has no way to the outside"),
        () -> alone.reported().getLast());
  }
}
