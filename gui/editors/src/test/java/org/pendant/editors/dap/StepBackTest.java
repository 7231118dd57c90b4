package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.editors.dap.DebugClient.refusal;

import com.google.gson.JsonObject;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.eclipse.lsp4j.debug.CancelArguments;
import org.eclipse.lsp4j.debug.GotoArguments;
import org.eclipse.lsp4j.debug.GotoTarget;
import org.eclipse.lsp4j.debug.GotoTargetsArguments;
import org.eclipse.lsp4j.debug.NextArguments;
import org.eclipse.lsp4j.debug.ReverseContinueArguments;
import org.eclipse.lsp4j.debug.SourceBreakpoint;
import org.eclipse.lsp4j.debug.StepBackArguments;
import org.eclipse.lsp4j.debug.SteppingGranularity;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.eclipse.lsp4j.debug.TerminateArguments;
import org.eclipse.lsp4j.debug.TerminateThreadsArguments;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StepBackTest {
  private static final String LOOP =
      """
      i = 0
      while i < 5:
        sleep(0.1)
        i = i + 1
        sleep(0.1)
      end
      done = True
      """;

  @TempDir private Path folder;

  /** Stopped behind the loop. */
  private DebugClient stopped() throws Exception {
    DebugClient client = DebugClient.of(folder, LOOP);
    client.launch();
    var _ = client.breakpoints(7);
    client.configured();
    client.stop();
    return client;
  }

  private static StoppedEventArguments stepBack(DebugClient client) throws Exception {
    client.server().stepBack(new StepBackArguments()).join();
    return client.stop();
  }

  private static StoppedEventArguments reverse(DebugClient client) throws Exception {
    client.server().reverseContinue(new ReverseContinueArguments()).join();
    return client.stop();
  }

  @Test
  void stepsBackThroughWhatTheProgramDidAndOnAgainUntilNow() throws Exception {
    try (DebugClient client = stopped()) {
      StoppedEventArguments stop = stepBack(client);
      assertEquals("step", stop.getReason());
      assertEquals("In the past, at 0.902 s; now is 1.002 s", stop.getDescription());
      assertEquals(5, client.line());
      assertEquals("5", client.values("Globals").get("i"));
      assertEquals("0.902 s", client.values("Robot").get("time"));
      stepBack(client);
      assertEquals(3, client.line());
      assertEquals("4", client.evaluate("i", "watch"));
      client.stepOver();
      client.stop();
      assertEquals(5, client.line());
      client.stepOver();
      assertEquals("Back to now", client.stop().getDescription());
      assertEquals(7, client.line());
      client.resume();
      assertEquals(0, client.end());
    }
  }

  @Test
  void continuesBackToABreakpointThatWasSetAfterwards() throws Exception {
    try (DebugClient client = stopped()) {
      SourceBreakpoint at = DebugClient.at(3);
      at.setCondition("i == 2");
      var _ = client.breakpoints(at, DebugClient.at(7));
      StoppedEventArguments stop = reverse(client);
      assertEquals("breakpoint", stop.getReason());
      assertEquals(3, client.line());
      assertEquals("2", client.evaluate("i", "hover"));
      assertEquals("entry", reverse(client).getReason());
      assertEquals(
          "the recording has no earlier breakpoint",
          refusal(client.server().reverseContinue(new ReverseContinueArguments())));
      client.resume();
      client.stop();
      assertEquals("2", client.evaluate("i", "watch"));
      client.resume();
      assertEquals("Back to now", client.stop().getDescription());
      assertEquals("5", client.evaluate("i", "watch"));
    }
  }

  @Test
  void nothingOfThePastIsChanged() throws Exception {
    try (DebugClient client = stopped()) {
      stepBack(client);
      String words = "the past cannot be changed: continue to now first";
      assertEquals(words, refusal(client.server().evaluate(client.evaluation("i = 9", "repl"))));
      assertEquals(words, refusal(client.server().goto_(new GotoArguments())));
      assertEquals(
          words, refusal(client.server().terminateThreads(new TerminateThreadsArguments())));
      assertEquals(
          "get_digital_in(0) is not in the recording: it has global variables, and no answers of"
              + " functions",
          refusal(client.server().evaluate(client.evaluation("get_digital_in(0)", "watch"))));
    }
  }

  @Test
  void eachStopOfTheDebuggerIsAStepOfThePastWithItsCalls() throws Exception {
    String text = "def f(x):\n  local y = x + 1\n  return y\nend\na = 1\nb = f(a)\nsleep(0.1)\n";
    try (DebugClient client = DebugClient.of(folder, text)) {
      client.launch();
      var _ = client.breakpoints(5);
      client.configured();
      client.stop();
      for (int i = 0; i < 4; i++) {
        client.stepInto();
        client.stop();
      }
      assertEquals(7, client.line());
      stepBack(client);
      assertEquals(List.of(3, 6), client.stack().stream().map(each -> each.getLine()).toList());
      stepBack(client);
      assertEquals(2, client.line());
      assertEquals("1", client.evaluate("a", "watch"));
    }
  }

  @Test
  void aMomentAtWhichNothingStoppedHasItsCallsToo() throws Exception {
    String text = "def grip(x):\n  a = x\n  sleep(0.3)\nend\nb = 1\ngrip(b)\nsleep(0.1)\n";
    try (DebugClient client = DebugClient.of(folder, text)) {
      client.launch();
      var _ = client.breakpoints(6);
      client.configured();
      client.stop();
      client.stepOver();
      client.stop();
      assertEquals(7, client.line());
      stepBack(client);
      assertEquals(List.of(3, 6), client.stack().stream().map(each -> each.getLine()).toList());
      assertEquals("grip", client.top().getName());
    }
  }

  @Test
  void framesAreStepsOfTheirOwn() throws Exception {
    try (DebugClient client = stopped()) {
      assertEquals("1.002 s", client.values("Robot").get("time"));
      StepBackArguments back = new StepBackArguments();
      back.setGranularity(SteppingGranularity.INSTRUCTION);
      client.server().stepBack(back).join();
      client.stop();
      assertEquals("1.000 s", client.values("Robot").get("time"));
    }
  }

  @Test
  void aFrameIsTheSmallestStepForward() throws Exception {
    try (DebugClient client = DebugClient.of(folder, LOOP)) {
      client.launch();
      var _ = client.breakpoints(3);
      client.configured();
      client.stop();
      NextArguments next = new NextArguments();
      next.setThreadId(1);
      next.setGranularity(SteppingGranularity.INSTRUCTION);
      client.server().next(next).join();
      assertEquals("step", client.stop().getReason());
      String before = client.values("Robot").get("time");
      client.server().next(next).join();
      client.stop();
      assertEquals("0.004 s", before);
      assertEquals("0.006 s", client.values("Robot").get("time"));
    }
  }

  @Test
  void aProgramThatHasEndedCanBeWalkedBack() throws Exception {
    try (DebugClient client = DebugClient.of(folder, LOOP)) {
      client.launch(Map.of("stopAtEnd", true));
      client.configured();
      StoppedEventArguments stop = client.stop();
      assertEquals("ended", stop.getReason());
      assertEquals("The program has ended", stop.getDescription());
      assertEquals("5", client.evaluate("i", "watch"));
      assertEquals(
          "the program has ended, nothing can be changed",
          refusal(client.server().evaluate(client.evaluation("i = 9", "repl"))));
      stepBack(client);
      assertEquals(5, client.line());
      stepBack(client);
      assertEquals("4", client.evaluate("i", "watch"));
      client.resume();
      assertEquals("Back to now", client.stop().getDescription());
      client.stepOver();
      assertEquals(0, client.end());
    }
  }

  @Test
  void whoEndsAProgramDoesNotWantToLookBack() throws Exception {
    try (DebugClient client = DebugClient.of(folder, LOOP)) {
      client.launch(Map.of("stopAtEnd", true));
      var _ = client.breakpoints(3);
      client.configured();
      client.stop();
      client.server().terminate(new TerminateArguments()).join();
      assertEquals(0, client.end());
    }
  }

  private static final String WRITING =
      """
      i = 0
      while i < 5:
        i = i + 1
        textmsg("turn ", i)
        sleep(0.1)
      end
      sleep(0.1)
      """;

  @Test
  void aLineOfOutputLeadsToTheMomentAtWhichItWasWritten() throws Exception {
    try (DebugClient client = DebugClient.of(folder, WRITING)) {
      client.launch();
      var _ = client.breakpoints(7);
      client.configured();
      client.stop();
      GotoTargetsArguments asked = new GotoTargetsArguments();
      asked.setSource(client.source());
      asked.setLine(4);
      GotoTarget[] targets = client.server().gotoTargets(asked).join().getTargets();
      assertEquals(6, targets.length);
      assertEquals("Back to 0.302 s, when it wrote: turn 4", targets[2].getLabel());
      GotoArguments chosen = new GotoArguments();
      chosen.setThreadId(1);
      chosen.setTargetId(targets[2].getId());
      client.server().goto_(chosen).join();
      StoppedEventArguments stop = client.stop();
      assertEquals("goto", stop.getReason());
      assertTrue(stop.getDescription().endsWith("here was written: turn 4"), stop.getDescription());
      assertEquals("0.302 s", client.values("Robot").get("time"));
    }
  }

  @Test
  void allLinesOfOutputAreToldWithTheirMoments() throws Exception {
    try (DebugClient client = DebugClient.of(folder, WRITING)) {
      client.launch();
      var _ = client.breakpoints(7);
      client.configured();
      client.stop();
      JsonObject last =
          client
              .server()
              .moments(Map.of())
              .join()
              .getAsJsonArray("moments")
              .get(4)
              .getAsJsonObject();
      assertEquals("turn 5", last.get("text").getAsString());
      assertEquals(4, last.get("line").getAsInt());
      int id = last.get("id").getAsInt();
      client.server().goToMoment(Map.of("id", id - 3)).join();
      StoppedEventArguments stop = client.stop();
      assertTrue(stop.getDescription().endsWith("here was written: turn 2"), stop.getDescription());
      assertEquals(
          "that line of output is not known any more",
          refusal(client.server().goToMoment(Map.of("id", 9999))));
      client.server().cancel(new CancelArguments()).join();
    }
  }

  @Test
  void aRunningProgramIsNotSteppedBack() throws Exception {
    try (DebugClient client = DebugClient.of(folder, "while True:\n  sync()\nend\n")) {
      client.launch();
      client.configured();
      assertEquals(
          "the program is not stopped", refusal(client.server().stepBack(new StepBackArguments())));
    }
  }

  @Test
  void theBeginningOfTheRecordingIsTheEnd() throws Exception {
    try (DebugClient client = DebugClient.of(folder, "a = 1\nsleep(0.1)\n")) {
      client.launch();
      var _ = client.breakpoints(1);
      client.configured();
      client.stop();
      assertTrue(
          refusal(client.server().stepBack(new StepBackArguments()))
              .startsWith("the recording has no earlier statement"));
    }
  }
}
