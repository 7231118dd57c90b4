package org.pendant.editors.dap;

import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.eclipse.lsp4j.jsonrpc.services.JsonRequest;

/** Move requests, which the protocol has no word for: steps from move to move. */
public final class MoveRequests {
  private final DebugSession session;
  private final ExecutionRequests execution;

  MoveRequests(DebugSession session, ExecutionRequests execution) {
    this.session = session;
    this.execution = execution;
  }

  /**
   * A step that is asked for.
   *
   * @param threadId whose move may be under way; the main thread where it is absent
   * @param back whether it leads to where the last move began
   */
  record MoveStep(Integer threadId, Boolean back) {}

  /**
   * {@code pendant/stepToMove}: on to where a move begins, or where the one that is under way has
   * ended. What stopped there is told by {@link StoppedEventArguments#getDescription}.
   */
  @JsonRequest("pendant/stepToMove")
  public CompletableFuture<Void> stepToMove(MoveStep asked) {
    return session
        .thread()
        .request(
            () ->
                session.leadingAway(
                    execution.stepToMove(
                        asked == null || asked.threadId() == null ? 1 : asked.threadId(),
                        asked != null && Boolean.TRUE.equals(asked.back()))));
  }
}
