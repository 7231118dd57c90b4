package org.pendant.editors.lsp;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import org.pendant.editors.dryrun.DryRun;
import org.pendant.editors.dryrun.DryRunLimits;
import org.pendant.editors.dryrun.DryRunResult;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.source.Diagnostic;
import org.pendant.testing.builtin.TestCatalogue;

/**
 * Dry runs of the texts that the client has open, one after the other in a thread of their own.
 * What a run said counts as long as the text stays the same.
 */
final class DryRuns implements AutoCloseable {
  private final ServerSession session;
  private final Consumer<Document> told;
  private final Map<String, Kept> kept = new ConcurrentHashMap<>();
  private final ExecutorService runner =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread thread = new Thread(task, "language server dry runs");
            thread.setDaemon(true);
            return thread;
          });

  /**
   * What is known of a text.
   *
   * @param id names the text and the arm
   * @param result empty while it runs
   */
  private record Kept(String id, Optional<DryRunResult> result) {}

  /**
   * Dry runs for a session.
   *
   * @param told is told of each text whose run is over, by the thread of the runs
   */
  DryRuns(ServerSession session, Consumer<Document> told) {
    this.session = session;
    this.told = told;
  }

  /** Has {@code document} run, unless it is known what comes of it or it cannot run. */
  void ask(Document document) {
    String robot = session.settings().robot();
    String id = id(document, robot);
    boolean runs =
        !TestCatalogue.isFor(document.source().name())
            && !Optional.ofNullable(kept.get(document.uri())).map(Kept::id).equals(Optional.of(id));
    if (runs) {
      Kept waiting = new Kept(id, Optional.empty());
      kept.put(document.uri(), waiting);
      session.execute(runner, () -> run(document, robot, waiting));
    }
  }

  private void run(Document document, String robot, Kept waiting) {
    if (!waiting.equals(kept.get(document.uri()))
        || document.analysis().diagnostics().stream().anyMatch(Diagnostic::isError)) {
      return;
    }
    DryRunResult result =
        DryRun.of(
            document.source(),
            robot,
            DryRunLimits.STANDARD,
            () -> !waiting.equals(kept.get(document.uri())) || runner.isShutdown());
    if (kept.replace(document.uri(), waiting, new Kept(waiting.id(), Optional.of(result)))) {
      told.accept(document);
    }
  }

  /** What a run of exactly this text came to; empty as long as there is none. */
  Optional<DryRunResult> of(Document document) {
    return Optional.ofNullable(kept.get(document.uri()))
        .filter(each -> each.id().equals(id(document, session.settings().robot())))
        .flatMap(Kept::result);
  }

  void forget(String uri) {
    kept.remove(uri);
  }

  private static String id(Document document, String robot) {
    return robot + " " + DiagnosticReports.id(document);
  }

  @Override
  public void close() {
    runner.shutdownNow();
  }
}
