package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.debug.InitializeRequestArguments;
import org.eclipse.lsp4j.debug.ProgressEndEventArguments;
import org.eclipse.lsp4j.debug.ProgressStartEventArguments;
import org.eclipse.lsp4j.debug.services.IDebugProtocolClient;
import org.junit.jupiter.api.Test;

class ProgressEventsTest {
  private final List<String> told = new ArrayList<>();
  private final List<Runnable> later = new ArrayList<>();

  private final IDebugProtocolClient client =
      new IDebugProtocolClient() {
        @Override
        public void progressStart(ProgressStartEventArguments begun) {
          told.add(begun.getProgressId() + " " + begun.getTitle());
        }

        @Override
        public void progressEnd(ProgressEndEventArguments ended) {
          told.add(ended.getProgressId() + " over");
        }
      };

  /** What was told of work, after {@code patience} and at its end. */
  private List<String> told(boolean shows, boolean slow) throws Exception {
    try (SessionThread thread = new SessionThread()) {
      DebugSession session = new DebugSession(thread, () -> client);
      InitializeRequestArguments form = new InitializeRequestArguments();
      form.setSupportsProgressReporting(shows);
      session.talkTo(ClientForm.of(form), true);
      CompletableFuture<String> work = new CompletableFuture<>();
      var _ = new ProgressEvents(session, later::add).of("Reading a", false, work);
      if (!slow) {
        work.complete("done");
      }
      later.forEach(Runnable::run);
      work.complete("done");
      CompletableFuture<Boolean> turn = new CompletableFuture<>();
      thread.execute(() -> turn.complete(true));
      turn.get();
      return told;
    }
  }

  @Test
  void workThatTakesLongIsToldOfUntilItIsOver() throws Exception {
    assertEquals(List.of("pendant-1 Reading a", "pendant-1 over"), told(true, true));
  }

  @Test
  void shortWorkNeedsNoWords() throws Exception {
    assertEquals(List.of(), told(true, false));
  }

  @Test
  void aClientThatShowsNoProgressIsNotToldOfIt() throws Exception {
    assertEquals(List.of(), told(false, true));
  }

  @Test
  void oneOfSeveralIsGivenUp() throws Exception {
    try (SessionThread thread = new SessionThread()) {
      DebugSession session = new DebugSession(thread, () -> client);
      InitializeRequestArguments form = new InitializeRequestArguments();
      form.setSupportsProgressReporting(true);
      session.talkTo(ClientForm.of(form), true);
      ProgressEvents progress = new ProgressEvents(session, Runnable::run);
      CompletableFuture<String> one = new CompletableFuture<>();
      CompletableFuture<String> other = new CompletableFuture<>();
      CompletableFuture<String> launch = new CompletableFuture<>();
      var _ = progress.of("Searching", true, one);
      var _ = progress.of("Searching", true, other);
      var _ = progress.of("Launching", false, launch);
      progress.cancel("pendant-2");
      progress.cancel("pendant-3");
      progress.cancel("pendant-4");
      assertFalse(one.isDone());
      assertTrue(other.isCancelled());
      assertFalse(launch.isDone());
    }
  }
}
