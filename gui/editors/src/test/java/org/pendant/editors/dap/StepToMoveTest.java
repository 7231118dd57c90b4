package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.editors.dap.DebugClient.refusal;

import java.nio.file.Path;
import java.util.Map;
import org.eclipse.lsp4j.debug.ContinuedEventArguments;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StepToMoveTest {
  private static final String WORK =
      """
      def reach(q):
        movej(q, a=5, v=2)
        textmsg("there")
      end
      q = get_actual_joint_positions()
      i = 0
      while i < 2:
        q[0] = q[0] + 0.1
        movej(q, a=5, v=2)
        i = i + 1
        sleep(0.1)
      end
      reach(q)
      q[0] = 0
      movej(q, a=5, v=2, r=0.01)
      q[1] = q[1] - 0.1
      movej(q, a=5, v=2)
      movel(get_forward_kin(), a=3)
      """;

  @TempDir private Path folder;

  private DebugClient stopped(int line) throws Exception {
    DebugClient client = DebugClient.of(folder, WORK);
    client.launch(Map.of("stopAtEnd", true));
    var _ = client.breakpoints(line);
    client.configured();
    client.stop();
    var _ = client.breakpoints(new int[0]);
    return client;
  }

  private static void stepTo(DebugClient client, int line, String words) throws Exception {
    client.stepToMove();
    client.next(ContinuedEventArguments.class);
    StoppedEventArguments stop = client.stop();
    assertEquals("step", stop.getReason());
    assertEquals(words, stop.getDescription());
    assertEquals(line, client.line());
  }

  @Test
  void stepsFromTheBeginOfAMoveToItsEndAndOnToTheNext() throws Exception {
    try (DebugClient client = stopped(6)) {
      stepTo(client, 9, "Paused: here a move begins");
      assertEquals("0", client.evaluate("i", "watch"));
      stepTo(client, 10, "Paused: here the move has ended");
      stepTo(client, 9, "Paused: here a move begins");
      assertEquals("1", client.evaluate("i", "watch"));
      stepTo(client, 10, "Paused: here the move has ended");
    }
  }

  @Test
  void aMoveInAFunctionThatIsCalledIsSteppedTo() throws Exception {
    try (DebugClient client = stopped(13)) {
      stepTo(client, 2, "Paused: here a move begins");
      stepTo(client, 3, "Paused: here the move has ended");
      stepTo(client, 15, "Paused: here a move begins");
    }
  }

  @Test
  void aMoveThatBlendsEndsWhereTheNextOneTakesOver() throws Exception {
    try (DebugClient client = stopped(15)) {
      stepTo(client, 16, "Paused: here the move has ended");
      stepTo(client, 17, "Paused: here a move begins");
      stepTo(client, 18, "Paused: here a move begins");
      client.stepToMove();
      assertEquals("ended", client.stop().getReason());
    }
  }

  @Test
  void movesOfThePastAreSteppedBackToAndOnAgain() throws Exception {
    try (DebugClient client = stopped(14)) {
      client.server().stepToMove(Map.of("back", true)).join();
      StoppedEventArguments stop = client.stop();
      assertTrue(stop.getDescription().endsWith("; here a move begins"), stop.getDescription());
      assertEquals(2, client.line());
      client.server().stepToMove(Map.of("back", true)).join();
      client.stop();
      assertEquals(9, client.line());
      assertEquals("1", client.evaluate("i", "watch"));
      for (int line : new int[] {11, 2}) {
        client.stepToMove();
        client.stop();
        assertEquals(line, client.line());
      }
      client.stepToMove();
      assertEquals("Back to now", client.stop().getDescription());
      assertEquals(14, client.line());
    }
  }

  @Test
  void whereNothingWasMovedThereIsNothingToGoBackTo() throws Exception {
    try (DebugClient client = stopped(6)) {
      assertEquals(
          "the recording has no earlier move",
          refusal(client.server().stepToMove(Map.of("back", true))));
    }
  }

  @Test
  void aRunningProgramHasNoSteps() throws Exception {
    try (DebugClient client = DebugClient.of(folder, "while True:\n  sync()\nend\n")) {
      client.launch();
      client.configured();
      assertEquals(
          "the program is not stopped", refusal(client.server().stepToMove(Map.of("threadId", 1))));
    }
  }
}
