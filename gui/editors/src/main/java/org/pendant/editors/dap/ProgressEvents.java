package org.pendant.editors.dap;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
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
  private final Map<String, CompletableFuture<?>> cancellable = new HashMap<>();
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
   * @param mayGiveUp whether the client may give it up
   */
  <T> CompletableFuture<T> of(String title, boolean mayGiveUp, CompletableFuture<T> work) {
    if (!session.form().progress()) {
      return work;
    }
    String id = "pendant-" + ++last;
    later.execute(
        () -> {
          if (!work.isDone()) {
            begin(id, title, mayGiveUp);
            if (mayGiveUp) {
              cancellable.put(id, work);
            }
            var _ = work.whenCompleteAsync((value, fault) -> end(id), session.thread());
          }
        });
    return work;
  }

  /** Gives up the work that was told of as {@code id}, if the client may do so. */
  void cancel(String id) {
    Optional.ofNullable(cancellable.get(id)).ifPresent(work -> work.cancel(true));
  }

  private void begin(String id, String title, boolean mayGiveUp) {
    ProgressStartEventArguments told = new ProgressStartEventArguments();
    told.setProgressId(id);
    told.setTitle(session.form().shown(title));
    told.setCancellable(mayGiveUp);
    session.client().progressStart(told);
  }

  private void end(String id) {
    cancellable.remove(id);
    ProgressEndEventArguments told = new ProgressEndEventArguments();
    told.setProgressId(id);
    session.client().progressEnd(told);
  }
}
