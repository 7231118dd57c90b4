package org.pendant.editors.lsp;

import static org.pendant.editors.lsp.LanguageServerTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentPositionParams;
import org.eclipse.lsp4j.jsonrpc.services.JsonRequest;
import org.pendant.editors.dryrun.DryRunResult;
import org.pendant.editors.dryrun.DryRunResult.Trouble;
import org.pendant.editors.lsp.provider.ClientFeatures;
import org.pendant.editors.lsp.provider.Hovers;
import org.pendant.editors.lsp.provider.RequestRefusal;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.source.ByteText;

/**
 * Robot requests: what the protocol has no word for: the pose at a place, and what a dry run says.
 */
public final class RobotRequests {
  private final ServerSession session;
  private final DryRuns dryRuns;

  RobotRequests(ServerSession session, DryRuns dryRuns) {
    this.session = session;
    this.dryRuns = dryRuns;
  }

  /**
   * A pose of numbers in a text.
   *
   * @param range where it stands
   * @param pose x, y, z in m, then the rotation vector in rad
   */
  record PoseAnswer(Range range, List<Double> pose) {
    PoseAnswer {
      pose = List.copyOf(pose);
    }
  }

  /**
   * What a dry run came to.
   *
   * @param outcome {@code finished}, {@code failed}, {@code stopped}, {@code given_up} or {@code
   *     not_run}
   * @param line where it was stopped, from 1; absent when it was not
   * @param message why; absent as well
   * @param timeS robot time, s
   * @param lines what each line took
   */
  record DryRunAnswer(
      String outcome, Integer line, String message, double timeS, List<LineAnswer> lines) {
    DryRunAnswer {
      lines = List.copyOf(lines);
    }
  }

  /**
   * What a line took.
   *
   * @param line from 1
   * @param timeS robot time of all its executions, s
   * @param pathM way of the tool, m
   */
  record LineAnswer(int line, long executions, double timeS, double pathM) {}

  /** {@code pendant/pose}: the pose of six numbers under the caret; null where there is none. */
  @JsonRequest("pendant/pose")
  public CompletableFuture<Object> pose(TextDocumentPositionParams asked) {
    Optional<Document> document = session.documents().find(asked.getTextDocument().getUri());
    if (document.isEmpty()) {
      return CompletableFuture.failedFuture(notOpen(asked));
    }
    return session.answer(
        cancelled ->
            Hovers.poseAt(document.get(), document.get().offset(asked.getPosition()))
                .map(
                    pose ->
                        (Object)
                            new PoseAnswer(document.get().range(pose.range()), pose.elements()))
                .orElse(null));
  }

  /**
   * {@code pendant/dryRun}: what the dry run of a text has come to; null as long as there is none,
   * it begins then. The position is not looked at.
   */
  @JsonRequest("pendant/dryRun")
  public CompletableFuture<Object> dryRun(TextDocumentPositionParams asked) {
    Optional<Document> document = session.documents().find(asked.getTextDocument().getUri());
    if (document.isEmpty()) {
      return CompletableFuture.failedFuture(notOpen(asked));
    }
    return session.answer(
        cancelled -> {
          Optional<DryRunResult> known = dryRuns.of(document.get());
          if (known.isEmpty()) {
            dryRuns.ask(document.get());
          }
          return known.<Object>map(result -> answer(result, session.features())).orElse(null);
        });
  }

  private static RuntimeException notOpen(TextDocumentPositionParams asked) {
    return RequestRefusal.ofParameters(text("notOpen", asked.getTextDocument().getUri()));
  }

  private static DryRunAnswer answer(DryRunResult result, ClientFeatures client) {
    return new DryRunAnswer(
        result.outcome().name().toLowerCase(Locale.ROOT),
        result.trouble().map(Trouble::line).orElse(null),
        result
            .trouble()
            .map(Trouble::message)
            .map(ByteText::decoded)
            .map(client::shown)
            .orElse(null),
        result.timeS(),
        result.lines().stream()
            .map(each -> new LineAnswer(each.line(), each.executions(), each.timeS(), each.pathM()))
            .toList());
  }
}
