package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.editors.dap.DebugClient.refusal;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.eclipse.lsp4j.debug.Breakpoint;
import org.eclipse.lsp4j.debug.BreakpointLocation;
import org.eclipse.lsp4j.debug.BreakpointLocationsArguments;
import org.eclipse.lsp4j.debug.ExceptionInfoArguments;
import org.eclipse.lsp4j.debug.ExceptionInfoResponse;
import org.eclipse.lsp4j.debug.FunctionBreakpoint;
import org.eclipse.lsp4j.debug.GotoArguments;
import org.eclipse.lsp4j.debug.GotoTargetsArguments;
import org.eclipse.lsp4j.debug.LoadedSourcesArguments;
import org.eclipse.lsp4j.debug.RestartArguments;
import org.eclipse.lsp4j.debug.SetBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetExceptionBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetFunctionBreakpointsArguments;
import org.eclipse.lsp4j.debug.Source;
import org.eclipse.lsp4j.debug.SourceArguments;
import org.eclipse.lsp4j.debug.SourceBreakpoint;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.eclipse.lsp4j.debug.TerminateThreadsArguments;
import org.eclipse.lsp4j.debug.Thread;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DebugStopsTest {
  private static final String LOOP =
      """
      def add(x):
        def inner():
          return 1
        end
        return x + inner()
      end
      i = 0
      while i < 10:
        i = add(i)
        sleep(0.01)
      end
      """;

  @TempDir private Path folder;

  private DebugClient launched(String text) throws Exception {
    DebugClient client = DebugClient.of(folder, text);
    client.launch();
    return client;
  }

  private static void stopAt(DebugClient client, String... filters) {
    SetExceptionBreakpointsArguments arguments = new SetExceptionBreakpointsArguments();
    arguments.setFilters(filters);
    var _ = client.server().setExceptionBreakpoints(arguments).join();
  }

  private static Breakpoint[] functions(DebugClient client, String... names) {
    SetFunctionBreakpointsArguments arguments = new SetFunctionBreakpointsArguments();
    arguments.setBreakpoints(
        Arrays.stream(names)
            .map(
                name -> {
                  FunctionBreakpoint breakpoint = new FunctionBreakpoint();
                  breakpoint.setName(name);
                  return breakpoint;
                })
            .toArray(FunctionBreakpoint[]::new));
    return client.server().setFunctionBreakpoints(arguments).join().getBreakpoints();
  }

  @Test
  void aConditionDecidesWhetherABreakpointStops() throws Exception {
    try (DebugClient client = launched(LOOP)) {
      SourceBreakpoint at = DebugClient.at(9);
      at.setCondition("i == 7");
      assertTrue(client.breakpoints(at)[0].isVerified());
      client.configured();
      client.stop();
      assertEquals("7", client.evaluate("i", "watch"));
      client.resume();
      assertEquals(0, client.end());
    }
  }

  @Test
  void aHitConditionPassesTheFirstHits() throws Exception {
    try (DebugClient client = launched(LOOP)) {
      SourceBreakpoint at = DebugClient.at(9);
      at.setHitCondition("> 4");
      var _ = client.breakpoints(at);
      client.configured();
      client.stop();
      assertEquals("4", client.evaluate("i", "watch"));
    }
  }

  @Test
  void aLogPointPrintsAndStopsNothing() throws Exception {
    try (DebugClient client = launched(LOOP)) {
      SourceBreakpoint at = DebugClient.at(9);
      at.setLogMessage("i is {i}");
      at.setHitCondition(">= 9");
      var _ = client.breakpoints(at);
      client.configured();
      assertEquals(0, client.end());
      assertTrue(client.said("console").contains("i is 8\ni is 9\n"), client.said());
      assertFalse(client.said("console").contains("i is 7"));
    }
  }

  @Test
  void aBreakpointThatMakesNoSenseIsNotVerifiedAndSaysWhy() throws Exception {
    try (DebugClient client = launched(LOOP)) {
      SourceBreakpoint condition = DebugClient.at(9);
      condition.setCondition("i = 7");
      SourceBreakpoint hits = DebugClient.at(9);
      hits.setHitCondition("every 2");
      Breakpoint[] told = client.breakpoints(condition, hits);
      assertFalse(told[0].isVerified());
      assertTrue(told[0].getMessage().contains("= assigns"), told[0].getMessage());
      assertEquals(
          "hit condition is every 2, must be a number, such as 5, or >= 5, > 5, == 5, <= 5, < 5, %"
              + " 5",
          told[1].getMessage());
    }
  }

  @Test
  void linesWhereAProgramCanStopAreTold() throws Exception {
    try (DebugClient client = launched(LOOP)) {
      BreakpointLocationsArguments arguments = new BreakpointLocationsArguments();
      arguments.setSource(client.source());
      arguments.setLine(1);
      arguments.setEndLine(8);
      assertEquals(
          List.of(3, 5, 7, 8),
          Arrays.stream(client.server().breakpointLocations(arguments).join().getBreakpoints())
              .map(BreakpointLocation::getLine)
              .toList());
    }
  }

  @Test
  void aFunctionStopsAtItsFirstStatement() throws Exception {
    try (DebugClient client = launched(LOOP)) {
      Breakpoint[] told = functions(client, "add", "sub");
      assertEquals(5, told[0].getLine());
      assertEquals("the program has no function sub", told[1].getMessage());
      client.configured();
      StoppedEventArguments stop = client.stop();
      assertEquals("function breakpoint", stop.getReason());
      assertEquals(List.of(told[0].getId()), List.of(stop.getHitBreakpointIds()));
      assertEquals(5, client.line());
    }
  }

  @Test
  void aProgramIsHeldBeforeItFailsAndTheFailureIsTold() throws Exception {
    try (DebugClient client = launched("a = [1, 2]\ni = 5\ntextmsg(a[i])\n")) {
      stopAt(client, "error");
      client.configured();
      StoppedEventArguments stop = client.stop();
      assertEquals("exception", stop.getReason());
      ExceptionInfoResponse info =
          client.server().exceptionInfo(new ExceptionInfoArguments()).join();
      assertEquals(stop.getText(), info.getDescription());
      assertEquals("5", client.evaluate("i", "watch"));
      client.resume();
      assertEquals(1, client.end());
    }
  }

  @Test
  void aProtectiveStopIsLookedAtBeforeItEndsTheProgram() throws Exception {
    try (DebugClient client = launched("a = 1\nprotective_stop()\nsleep(1)\na = 2\n")) {
      stopAt(client, "safetyStop");
      client.configured();
      StoppedEventArguments stop = client.stop();
      assertEquals("exception", stop.getReason());
      assertTrue(stop.getText().startsWith("C"), stop.getText());
      assertEquals("1", client.values("Globals").get("a"));
      assertEquals("protective_stop", client.values("Robot").get("safety_mode"));
      client.resume();
      assertEquals(1, client.end());
      assertTrue(client.said("stderr").contains("stopped in line "), client.said());
    }
  }

  @Test
  void withoutAFilterAProtectiveStopEndsTheProgram() throws Exception {
    try (DebugClient client = launched("protective_stop()\nsleep(1)\n")) {
      client.configured();
      assertEquals(1, client.end());
    }
  }

  @Test
  void goingToALineRunsWhatIsBetween() throws Exception {
    try (DebugClient client = launched("a = 1\nsleep(0.1)\na = 2\na = 3\n")) {
      var _ = client.breakpoints(1);
      client.configured();
      client.stop();
      GotoTargetsArguments asked = new GotoTargetsArguments();
      asked.setSource(client.source());
      asked.setLine(4);
      var target = client.server().gotoTargets(asked).join().getTargets()[0];
      assertEquals("Run to line 4: what is between is carried out", target.getLabel());
      GotoArguments to = new GotoArguments();
      to.setThreadId(1);
      to.setTargetId(target.getId());
      client.server().goto_(to).join();
      assertEquals("goto", client.stop().getReason());
      assertEquals("2", client.evaluate("a", "watch"));
      asked.setLine(9);
      assertEquals(
          "no statement begins here or after it", refusal(client.server().gotoTargets(asked)));
    }
  }

  @Test
  void threadsAreToldOfAndEnded() throws Exception {
    String text =
        """
        thread work():
          while True:
            sleep(0.01)
          end
        end
        h = run work()
        sleep(0.1)
        a = 1
        """;
    try (DebugClient client = launched(text)) {
      var _ = client.breakpoints(8);
      client.configured();
      client.stop();
      Thread[] threads = client.server().threads().join().getThreads();
      assertEquals(2, threads.length);
      assertEquals("work (in sleep)", threads[1].getName());
      TerminateThreadsArguments arguments = new TerminateThreadsArguments();
      arguments.setThreadIds(new int[] {threads[1].getId()});
      client.server().terminateThreads(arguments).join();
      assertEquals(1, client.server().threads().join().getThreads().length);
      client.resume();
      assertEquals(0, client.end());
      int id = threads[1].getId();
      assertEquals(
          List.of("1 started", id + " started", id + " exited", "1 exited"), client.threads());
    }
  }

  @Test
  void theScriptOfATreeIsShownAndStopsAtBreakpoints() throws Exception {
    try (DebugClient client = DebugClient.of(folder, "a = 1\nb = 2\n")) {
      client.launch(Map.of("args", List.of("--tree")));
      Source script =
          client.server().loadedSources(new LoadedSourcesArguments()).join().getSources()[0];
      assertEquals("tree.script", script.getName());
      SourceArguments asked = new SourceArguments();
      asked.setSource(script);
      asked.setSourceReference(script.getSourceReference());
      assertEquals("a = 1\nb = 2\n", client.server().source(asked).join().getContent());
      var arguments = new SetBreakpointsArguments();
      arguments.setSource(script);
      arguments.setBreakpoints(new SourceBreakpoint[] {DebugClient.at(2)});
      assertTrue(client.server().setBreakpoints(arguments).join().getBreakpoints()[0].isVerified());
      assertFalse(client.breakpoints(1)[0].isVerified());
      client.configured();
      client.stop();
      assertEquals(2, client.line());
      assertEquals(1, client.top().getSource().getSourceReference());
    }
  }

  @Test
  void aRestartRunsTheTextAsItIsNow() throws Exception {
    try (DebugClient client = launched("a = 1\nsleep(0.1)\ntextmsg(a)\n")) {
      var _ = client.breakpoints(2);
      client.configured();
      client.stop();
      Files.writeString(folder.resolve("program.script"), "a = 2\nsleep(0.1)\ntextmsg(a)\n");
      client.server().restart(new RestartArguments()).join();
      client.stop();
      client.resume();
      assertEquals(0, client.end());
      assertEquals("2\n", client.said("stdout"));
    }
  }

  @Test
  void withoutDebuggingNothingStopsTheProgram() throws Exception {
    try (DebugClient client = DebugClient.of(folder, LOOP)) {
      client.launch(Map.of("noDebug", true, "stopOnEntry", true));
      var _ = client.breakpoints(9);
      client.configured();
      assertEquals(0, client.end());
    }
  }
}
