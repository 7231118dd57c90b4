package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.session.RunTime;

final class PastRunTimeTest {
  private static final double FRAME_S = 0.002;

  private final RecordedRun run = new RecordedRun().frames(50).start("sleep(3)\n");
  private final List<String> told = new ArrayList<>();
  private final LookBack lookBack = new LookBack(run.ring::recording, told::add);
  private final Deque<Runnable> waiting = new ArrayDeque<>();
  private final PastRunTime past =
      new PastRunTime(lookBack, new RecordingReader<>(waiting::add, Runnable::run));

  private void lookAt(double timeS) {
    lookBack.take(run.state());
    lookBack.scrub(timeS);
    var _ = past.time();
    while (!waiting.isEmpty()) {
      waiting.remove().run();
    }
  }

  @Test
  void isThatOfTheMomentWithoutThePausesBefore() {
    run.frames(500).pause().frames(250);
    run.resume().frames(500);
    double beganS = run.ring.recording().programs().getFirst().timeS();
    lookAt(beganS + 0.4);
    assertEquals(0.4, past.time().ranS(beganS + 0.4), 2 * FRAME_S);
    lookAt(beganS + 2);
    assertEquals(1.5, past.time().ranS(beganS + 2), 4 * FRAME_S);
    assertEquals(0.5, past.time().pausedS(beganS + 2), 4 * FRAME_S);
    assertEquals(List.of(), told);
  }

  @Test
  void isWholeAfterTheEnd() {
    run.frames(2000);
    double lastS = run.state().timeS();
    lookAt(lastS - 0.1);
    assertEquals(3, past.time().ranS(lastS - 0.1), 4 * FRAME_S);
  }

  @Test
  void goesOnWithARunThatGoesOn() {
    run.frames(500);
    lookAt(run.state().timeS());
    run.frames(500);
    double laterS = run.state().timeS();
    lookAt(laterS);
    assertEquals(2, past.time().ranS(laterS), 4 * FRAME_S);
  }

  @Test
  void isUnknownForNowBeforeTheFirstProgramAndUntilItIsRead() {
    run.frames(500);
    assertFalse(past.time().known());
    lookAt(0.01);
    assertFalse(past.time().known());
    lookBack.scrub(run.state().timeS());
    assertEquals(RunTime.NONE, past.time());
  }
}
