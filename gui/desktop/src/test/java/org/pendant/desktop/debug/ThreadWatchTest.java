package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.SourceRange;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ThreadSnapshot;

final class ThreadWatchTest {
  private static final List<ThreadSnapshot> THREADS =
      List.of(
          new ThreadSnapshot(
              0,
              "main",
              "sleep",
              List.of(new ThreadSnapshot.Level("main", "main", 3, new SourceRange(0, 1)))));

  private final List<Consumer<List<ThreadSnapshot>>> asked = new ArrayList<>();
  private long nowMs;
  private int changes;

  /** Keeps questions for later; every one is for threads. */
  private final DebugLink link =
      new DebugLink() {
        @Override
        @SuppressWarnings("unchecked") // nothing else is asked here
        public <T> void ask(
            DebugLink.Request<T> request, Consumer<T> answer, Consumer<String> refusal) {
          asked.add(found -> answer.accept((T) found));
        }

        @Override
        public void resume(Consumer<String> refusal) {
          throw new AssertionError("it only looks");
        }
      };

  private final ThreadWatch watch = new ThreadWatch(link, () -> nowMs, () -> changes++);

  @Test
  void looksTwiceASecondAtMost() {
    for (nowMs = 0; nowMs < 1000; nowMs += 33) {
      watch.refresh(ProgramState.RUNNING, false);
      asked.forEach(each -> each.accept(THREADS));
    }
    assertEquals(2, asked.size());
    assertEquals(THREADS, watch.threads());
    assertEquals(1, changes, "the same threads at the same places are no news");
  }

  @Test
  void waitsForAnAnswerBeforeItAsksAgain() {
    watch.refresh(ProgramState.RUNNING, false);
    nowMs = 5000;
    watch.refresh(ProgramState.RUNNING, false);
    assertEquals(1, asked.size());
  }

  @Test
  void aProgramThatIsHeldOrHasEndedHasNoThreadsHere() {
    watch.refresh(ProgramState.RUNNING, false);
    asked.getFirst().accept(THREADS);
    watch.refresh(ProgramState.RUNNING, true);
    assertEquals(List.of(), watch.threads());
    watch.refresh(ProgramState.STOPPED, false);
    assertEquals(1, asked.size());
  }
}
