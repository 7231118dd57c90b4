package org.pendant.editors.dap;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.jsonrpc.services.JsonRequest;

/** Moment requests, which the protocol has no word for: from lines of output to their moments. */
public final class MomentRequests {
  private final DebugSession session;
  private final ExecutionRequests execution;

  MomentRequests(DebugSession session, ExecutionRequests execution) {
    this.session = session;
    this.execution = execution;
  }

  /** Which lines are known. */
  record Moments(List<WrittenMoment> moments) {
    Moments {
      moments = List.copyOf(moments);
    }
  }

  /**
   * A line of output.
   *
   * @param id by which {@code pendant/goToMoment} knows it
   * @param timeS robot time at which it was written, s
   * @param line of the program, as the client counts; absent where none wrote it
   */
  record WrittenMoment(int id, double timeS, Integer line, String text) {}

  /** Names a moment. */
  record MomentAsked(int id) {}

  /**
   * Asks for lines of output.
   *
   * @param after only for those that came after the one with this id; absent for all
   */
  record LinesAsked(Integer after) {}

  /** {@code pendant/moments}: the newest lines of output, the oldest of them first. */
  @JsonRequest("pendant/moments")
  public CompletableFuture<Moments> moments(LinesAsked asked) {
    int after = asked == null || asked.after() == null ? 0 : asked.after();
    return session
        .thread()
        .request(
            () ->
                CompletableFuture.completedFuture(
                    new Moments(
                        session.program().events().written().all().stream()
                            .filter(each -> each.id() > after)
                            .map(this::told)
                            .toList())));
  }

  private WrittenMoment told(WrittenLines.Written written) {
    return new WrittenMoment(
        written.id(),
        written.timeS(),
        written.line() > 0 ? session.form().line(written.line()) : null,
        written.text());
  }

  /** {@code pendant/goToMoment}: looks at the moment at which a line of output was written. */
  @JsonRequest("pendant/goToMoment")
  public CompletableFuture<Void> goToMoment(MomentAsked asked) {
    return session.thread().request(() -> session.leadingAway(execution.toMoment(asked.id())));
  }
}
