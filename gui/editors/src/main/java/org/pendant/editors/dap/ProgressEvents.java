package org.pendant.editors.dap;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import org.eclipse.lsp4j.debug.ProgressEndEventArguments;
import org.eclipse.lsp4j.debug.ProgressStartEventArguments;

/**
 * Progress events: tell clients that show it what takes long. Only the session's thread uses it.
 */
final class ProgressEvents {
  /** What is over by then needs no words, ms. */
  static final long PATIENCE_MS = 300;

  private final DebugSession session;
  private final Executor later;
  private int last;

  ProgressEvents(DebugSession session) {
    this(
        session,
        CompletableFuture.delayedExecutor(PATIENCE_MS, TimeUnit.MILLISECONDS, session.thread()));
  }

  /**
   * Progress of a session.
   *
   * @param later does something in the session's turn when patience is over
   */
  ProgressEvents(DebugSession session, Executor later) {
    this.session = session;
    this.later = later;
  }

  /**
   * Tells of work until it is over, if that takes long.
   *
   * @param cancellable whether the client may give it up
   */
  <T> CompletableFuture<T> of(String title, boolean cancellable, CompletableFuture<T> work) {
    if (!session.form().progress()) {
      return work;
    }
    String id = "pendant-" + ++last;
    later.execute(
        () -> {
          if (!work.isDone()) {
            begin(id, title, cancellable);
            var _ = work.whenCompleteAsync((value, fault) -> end(id), session.thread());
          }
        });
    return work;
  }

  private void begin(String id, String title, boolean cancellable) {
    ProgressStartEventArguments told = new ProgressStartEventArguments();
    told.setProgressId(id);
    told.setTitle(title);
    told.setCancellable(cancellable);
    session.client().progressStart(told);
  }

  private void end(String id) {
    ProgressEndEventArguments told = new ProgressEndEventArguments();
    told.setProgressId(id);
    session.client().progressEnd(told);
  }
}
