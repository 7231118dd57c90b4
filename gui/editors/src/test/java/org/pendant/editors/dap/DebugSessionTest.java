package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.editors.dap.DebugClient.refusal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.eclipse.lsp4j.debug.Breakpoint;
import org.eclipse.lsp4j.debug.DisconnectArguments;
import org.eclipse.lsp4j.debug.InitializeRequestArguments;
import org.eclipse.lsp4j.debug.PauseArguments;
import org.eclipse.lsp4j.debug.StackFrame;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.eclipse.lsp4j.debug.TerminateArguments;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DebugSessionTest {
  private static final String STEPS =
      """
      def steps():
        def twice(x):
          local y = x * 2
          return y
        end
        a = 1
        b = twice(a)
        textmsg("b is ", b)
        sleep(0.1)
      end
      """;

  @TempDir private Path folder;

  private DebugClient client(String text) throws IOException {
    return DebugClient.of(folder, text);
  }

  @Test
  void aProgramRunsToItsEndAndTellsWhatItPrints() throws Exception {
    try (DebugClient client = client(STEPS)) {
      client.launch();
      client.configured();
      assertEquals(0, client.end());
      assertEquals("b is 2\n", client.said("stdout"));
      assertEquals(List.of("1 started", "1 exited"), client.threads());
    }
  }

  @Test
  void stopsAtABreakpointAndShowsWhereItStandsAndWhatThereIs() throws Exception {
    try (DebugClient client = client(STEPS)) {
      client.launch();
      Breakpoint[] set = client.breakpoints(4);
      assertTrue(set[0].isVerified());
      client.configured();
      StoppedEventArguments stop = client.stop();
      assertEquals("breakpoint", stop.getReason());
      assertEquals(List.of(set[0].getId()), List.of(stop.getHitBreakpointIds()));
      List<StackFrame> stack = client.stack();
      assertEquals(List.of("twice", "steps"), stack.stream().map(StackFrame::getName).toList());
      assertEquals(List.of(4, 7), stack.stream().map(StackFrame::getLine).toList());
      assertEquals(Map.of("x", "1", "y", "2"), client.values("Locals"));
      assertEquals("1", client.values("Globals").get("a"));
      assertEquals("running", client.values("Robot").get("robot_mode"));
      assertTrue(client.values("I/O").containsKey("digital_in"));
      assertTrue(client.values("Registers").containsKey("input_float_register"));
      client.resume();
      assertEquals(0, client.end());
    }
  }

  @Test
  void stepsIntoOverAndOutOfFunctions() throws Exception {
    try (DebugClient client = client(STEPS)) {
      client.launch(Map.of("stopOnEntry", true));
      client.configured();
      assertEquals("entry", client.stop().getReason());
      assertEquals(6, client.line());
      client.stepOver();
      assertEquals("step", client.stop().getReason());
      assertEquals(7, client.line());
      client.stepInto();
      client.stop();
      assertEquals(3, client.line());
      client.stepOut();
      client.stop();
      assertEquals(8, client.line());
      client.resume();
      assertEquals(0, client.end());
    }
  }

  @Test
  void aBreakpointWithoutAStatementMovesToTheNextOne() throws Exception {
    try (DebugClient client = client(STEPS)) {
      client.launch();
      Breakpoint[] set = client.breakpoints(5, 10);
      assertEquals(6, set[0].getLine());
      assertEquals("moved to the next statement", set[0].getMessage());
      assertFalse(set[1].isVerified());
      assertEquals("no statement begins here or after it", set[1].getMessage());
    }
  }

  @Test
  void breakpointsThatWereSetBeforeTheLaunchAreToldOfWhenTheProgramIsThere() throws Exception {
    try (DebugClient client = client(STEPS)) {
      client.initialize();
      assertFalse(client.breakpoints(8)[0].isVerified());
      var launched =
          client.server().launch(Map.of("program", folder.resolve("program.script").toString()));
      client.configured();
      launched.join();
      assertEquals("breakpoint", client.stop().getReason());
      assertEquals(8, client.line());
    }
  }

  @Test
  void aHungProgramIsPausedAndEnded() throws Exception {
    try (DebugClient client = client("while True:\nend\n")) {
      client.launch();
      client.configured();
      client.server().pause(new PauseArguments()).join();
      assertEquals("pause", client.stop().getReason());
      client.resume();
      client.server().terminate(new TerminateArguments()).join();
      assertEquals(0, client.end());
    }
  }

  @Test
  void theClientMayLeaveAHungProgram() throws Exception {
    try (DebugClient client = client("while True:\nend\n")) {
      client.launch();
      client.configured();
      client.server().disconnect(new DisconnectArguments()).join();
    }
  }

  @Test
  void aProgramWithMistakesIsNotLaunchedAndAllOfThemAreShown() throws Exception {
    try (DebugClient client = client("a = 1\nb = foo(a)\nc = bar()\n")) {
      client.initialize();
      String program = folder.resolve("program.script").toString();
      String refusal = refusal(client.server().launch(Map.of("program", program)));
      assertTrue(refusal.startsWith(program + ":2:5: error: "), refusal);
      assertTrue(refusal.endsWith(" (and 1 more)"), refusal);
      assertEquals(List.of(2, 3), client.output().stream().map(each -> each.getLine()).toList());
      assertTrue(client.said("stderr").contains("b = foo(a)"));
    }
  }

  @Test
  void whatCannotBeLaunchedIsRefusedInWords() throws Exception {
    try (DebugClient client = client(STEPS)) {
      client.initialize();
      assertEquals(
          "program is missing, the file to be debugged", refusal(client.server().launch(Map.of())));
      assertEquals(
          "program is 5.0, must be a text", refusal(client.server().launch(Map.of("program", 5))));
      assertEquals(
          "nowhere.script: there is no such file",
          refusal(client.server().launch(Map.of("program", "nowhere.script"))));
      assertEquals(
          "--robot is ur99, did you mean ur5?",
          refusal(client.server().launch(Map.of("program", "x", "robot", "ur99"))));
    }
  }

  @Test
  void anErrorEndsTheProgramWithItsPlace() throws Exception {
    try (DebugClient client = client("a = [1, 2]\ntextmsg(a[2])\n")) {
      client.launch();
      client.configured();
      assertEquals(1, client.end());
      var told = client.output().getLast();
      assertEquals("stderr", told.getCategory());
      assertEquals(2, told.getLine());
      assertTrue(told.getOutput().contains("program.script:2:9: error: "), told.getOutput());
    }
  }

  @Test
  void linesAndColumnsAreCountedAsTheClientDoes() throws Exception {
    try (DebugClient client = client("a = \"ü\" sleep(0.1)\n")) {
      InitializeRequestArguments told = new InitializeRequestArguments();
      told.setLinesStartAt1(false);
      told.setColumnsStartAt1(false);
      told.setPathFormat("uri");
      client.server().initialize(told).join();
      Path program = folder.resolve("program.script");
      client.server().launch(Map.of("program", program.toString(), "stopOnEntry", true)).join();
      client.configured();
      client.stop();
      client.stepOver();
      client.stop();
      StackFrame top = client.top();
      assertEquals(0, top.getLine());
      assertEquals(8, top.getColumn());
      assertEquals(program.toUri().toString(), top.getSource().getPath());
    }
  }
}
