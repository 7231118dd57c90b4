package org.pendant.protocols.interpreter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.StateStream;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

class InterpreterServerTest {
  @TempDir Path folder;

  private RunningBox box;
  private InterpreterServer server;
  private Socket socket;
  private BufferedReader answers;

  @BeforeEach
  void open() throws IOException {
    open(RemoteControl.disabled());
  }

  private void open(RemoteControl remote) throws IOException {
    box = new RunningBox(ControllerOptions.headless(), remote);
    server =
        InterpreterServer.open(box.serverContext(), PortNumbers.anyFree(), folder.resolve("logs"));
    socket = new Socket(InetAddress.getLoopbackAddress(), server.ports().getFirst().number());
    socket.setSoTimeout(RunningBox.GIVE_UP_MS);
    answers =
        new BufferedReader(
            new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
  }

  @AfterEach
  void close() throws IOException {
    socket.close();
    server.close();
    box.close();
  }

  private void start(String... lines) {
    Program program = TestController.program(box.controller(), String.join("\n", lines));
    box.controller().submit(new ProgramCommand.StartProgram(program)).join();
  }

  private void interpreting() throws Exception {
    start("def im():", "  interpreter_mode()", "  textmsg(\"left\")", "end");
    // the first line that is acknowledged and begun shows that the mode is active
    try (StateStream.Subscription frames = box.controller().feed().follow()) {
      var _ = frames.take();
      var _ = frames.take();
    }
  }

  private void send(String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  private String ask(String line) throws IOException {
    send(line + "\n");
    return answers.readLine();
  }

  private void assertAnswers(String answer, String line) throws IOException {
    assertEquals(answer, ask(line));
  }

  private List<String> messages() {
    return box.controller().logSince(0).stream()
        .filter(each -> each.origin() == LogEntry.Origin.SCRIPT)
        .map(LogEntry::text)
        .toList();
  }

  private void awaitEnd() throws InterruptedException {
    try (StateStream.Subscription frames = box.controller().feed().follow()) {
      while (box.controller().state().program().state() != ProgramState.STOPPED) {
        var _ = frames.take();
      }
    }
  }

  @Test
  void discardsStatementsWhileNoProgramRuns() throws IOException {
    assertAnswers("discard: no program is running: textmsg(1)", "textmsg(1)");
    assertAnswers("state: 0: statelastexecuted", "statelastexecuted");
    assertAnswers("state: 0: statelastinterpreted", "statelastinterpreted");
    assertAnswers("state: 0: statelastcleared", "statelastcleared");
    assertAnswers("state: 0: stateunexecuted", "stateunexecuted");
  }

  @Test
  void acknowledgesStatementsUnderRisingNumbers() throws Exception {
    interpreting();
    assertAnswers("ack: 1: a = 20 + 1", "a = 20 + 1\r");
    assertAnswers("ack: 2: textmsg(a) textmsg(\"two\")", "textmsg(a) textmsg(\"two\")");
    assertAnswers("ack: 3: end_interpreter()", "end_interpreter()");
    awaitEnd();
    assertEquals(List.of("21", "two", "left"), messages());
  }

  @Test
  void discardsWhatDoesNotCompile() throws Exception {
    interpreting();
    String answer = ask("nothing(1)");
    assertTrue(answer.startsWith("discard: "), answer);
    assertTrue(answer.endsWith(": nothing(1)"), answer);
    assertAnswers("ack: 1: textmsg(1)", "textmsg(1)");
  }

  @Test
  void countsOnFromOneForEveryProgram() throws Exception {
    interpreting();
    ask("textmsg(1)");
    box.controller().submit(new ProgramCommand.StopProgram()).join();
    interpreting();
    assertAnswers("ack: 1: textmsg(2)", "textmsg(2)");
  }

  @Test
  void answersStatementsSentTogetherInTheirOrder() throws Exception {
    interpreting();
    StringBuilder lines = new StringBuilder();
    List<String> expected = new ArrayList<>();
    for (int i = 1; i <= 300; i++) {
      lines.append("a = ").append(i).append('\n');
      expected.add("ack: " + i + ": a = " + i);
    }
    send(lines.toString());
    for (String each : expected) {
      assertEquals(each, answers.readLine());
    }
  }

  @Test
  void controlLinesAreNotHeldUpByStatementsThatWait() throws Exception {
    interpreting();
    StringBuilder lines = new StringBuilder("sleep(1000)\nclear_interpreter()\n");
    for (int i = 0; i < 100; i++) {
      lines.append("a = 1\n");
    }
    send(lines.toString());
    assertEquals("ack: 1: sleep(1000)", answers.readLine());
    assertEquals("ack: 2: clear_interpreter()", answers.readLine());
    assertAnswers("state: 1: stateunexecuted", "stateunexecuted");
    // without the clear there is nothing left to wait for
    assertAnswers("ack: 0: skipbuffer", "skipbuffer");
    for (int i = 0; i < 100; i++) {
      assertEquals("ack: " + (i + 3) + ": a = 1", answers.readLine());
    }
  }

  @Test
  void abortEndsAMove() throws Exception {
    interpreting();
    ask("movej([1.5, -1.57, -1.57, -1.57, 1.57, 0], a=0.1, v=0.1)");
    ask("end_interpreter()");
    try (StateStream.Subscription frames = box.controller().feed().follow()) {
      while (!box.controller().state().arm().moving()) {
        var _ = frames.take();
      }
    }
    assertAnswers("ack: 0: abort", "abort");
    awaitEnd();
    assertEquals(List.of("left"), messages());
    assertTrue(box.controller().state().arm().targetPositionRad().get(0) < 1);
  }

  @Test
  void statementsBeforeTheModeAreQueued() throws Exception {
    start("def im():", "  sleep(0.05)", "  interpreter_mode(clearQueueOnEnter = False)", "end");
    assertAnswers("ack: 1: textmsg(\"early\")", "textmsg(\"early\")");
    ask("end_interpreter()");
    awaitEnd();
    assertEquals(List.of("early"), messages());
  }

  @Test
  void blankLinesAreNoStatements() throws Exception {
    interpreting();
    send("\n  \n\r\n");
    assertAnswers("ack: 1: textmsg(1)", "textmsg(1)");
  }

  @Test
  void inLocalControlNothingIsInterpreted() throws Exception {
    close();
    open(new RemoteControl(true, false));
    interpreting();
    assertAnswers("discard: the robot is not in remote control: textmsg(1)", "textmsg(1)");
    assertAnswers("discard: the robot is not in remote control: abort", "abort");
    assertAnswers("state: 0: statelastinterpreted", "statelastinterpreted");
  }

  @Test
  void disconnectsWhoSendsALineWithoutEnd() throws Exception {
    try {
      send("x".repeat(70_000));
      assertEquals(-1, socket.getInputStream().read());
    } catch (IOException e) {
      // reset, as there was something left to read for the server
      assertTrue(socket.isConnected());
    }
    assertTrue(box.nextLogged().contains("a line has more than 65536 bytes"));
  }

  @Test
  void everyAcknowledgedStatementIsLogged() throws Exception {
    interpreting();
    ask("textmsg(1)");
    ask("foo(");
    ask("end_interpreter()");
    awaitEnd();
    // closing writes what is left
    server.close();
    List<String> lines = Files.readAllLines(folder.resolve("logs/interpreter.0.log"));
    assertTrue(lines.getFirst().startsWith("log of interpreter mode, program im, begun "));
    assertEquals("e: 0 c: 1 : textmsg(1)", lines.get(1));
    assertEquals("e: 1 c: 2 : end_interpreter()", lines.get(2));
    assertEquals(3, lines.size());
  }
}
