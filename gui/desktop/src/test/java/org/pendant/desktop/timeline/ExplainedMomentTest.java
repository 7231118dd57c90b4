package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.recording.Recording;
import org.pendant.recording.explain.MotionExplanation;

final class ExplainedMomentTest {
  private final RecordedRun run =
      new RecordedRun().start("movej([0, -1.2, -1.5, -1.5, 1.5, 0], a=3, v=2)\n").frames(300);
  private final List<String> told = new ArrayList<>();
  private final Deque<Runnable> reads = new ArrayDeque<>();
  private final LookBack lookBack = new LookBack(run.ring::recording, told::add);
  private final ExplainedMoment moment = moment(ExplainedMomentTest::explain);

  private ExplainedMoment moment(ExplainedMoment.Explainer explainer) {
    return new ExplainedMoment(
        lookBack, explainer, told::add, new RecordingReader<>(reads::add, Runnable::run));
  }

  private static MotionExplanation explain(Recording recording, long frame, boolean ofFile) {
    return MotionExplanation.of(
        recording, frame, SafetyConfiguration.standard(recording.arm()), false);
  }

  private Optional<Long> explainedFrame() {
    return moment.explanation().map(each -> each.now().frame());
  }

  @Test
  void theFramesAroundTheMomentAreReadOutsideOfTheThreadThatAsks() {
    lookBack.scrub(0.2);
    assertEquals(Optional.empty(), explainedFrame());
    reads.remove().run();
    assertEquals(Optional.of(100L), explainedFrame());
    assertTrue(reads.isEmpty(), "nothing is read twice");
  }

  @Test
  void theExplanationBeforeStaysUntilTheNewestIsThereAndNoneBetweenIsRead() {
    lookBack.scrub(0.2);
    moment.explanation();
    reads.remove().run();
    lookBack.scrub(0.3);
    assertEquals(Optional.of(100L), explainedFrame());
    lookBack.scrub(0.4);
    moment.explanation();
    lookBack.scrub(0.5);
    moment.explanation();
    reads.remove().run();
    reads.remove().run();
    assertTrue(reads.isEmpty());
    assertEquals(Optional.of(250L), explainedFrame());
  }

  @Test
  void nothingIsExplainedToWhoIsBackFromThePast() {
    lookBack.scrub(0.2);
    moment.explanation();
    lookBack.live();
    assertEquals(Optional.empty(), explainedFrame());
    reads.remove().run();
    assertEquals(Optional.empty(), explainedFrame());
  }

  @Test
  void whatCannotBeReadIsTold() {
    ExplainedMoment broken =
        moment(
            (recording, frame, ofFile) -> {
              throw new UncheckedIOException(new IOException("run.rec is gone"));
            });
    lookBack.scrub(0.2);
    broken.explanation();
    reads.remove().run();
    assertEquals(List.of("That moment cannot be explained: run.rec is gone"), told);
    assertEquals(Optional.empty(), broken.explanation());
  }
}
