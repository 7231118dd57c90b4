package org.pendant.editors.lsp;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.pendant.editors.lsp.text.Document;

/**
 * Diagnostic publisher: sends what is wrong in a text soon after it has changed, once for several
 * changes in a row. Clients that ask by themselves are sent nothing.
 */
final class DiagnosticPublisher {
  /** Time in which further changes are waited for. */
  private static final long QUIET_MS = 30;

  private final ServerSession session;
  private final DiagnosticReports reports;
  private final Map<String, Document> waiting = new ConcurrentHashMap<>();

  DiagnosticPublisher(ServerSession session, DiagnosticReports reports) {
    this.session = session;
    this.reports = reports;
  }

  void opened(Document document) {
    publish(document, 0);
  }

  /** More is known of {@code document} than before. */
  void learned(Document document) {
    if (session.features().pullsDiagnostics()) {
      if (session.features().refreshesDiagnostics()) {
        var _ = session.client().refreshDiagnostics();
      }
    } else if (session.documents().find(document.uri()).filter(document::equals).isPresent()) {
      publish(document, 0);
    }
  }

  void changed(Document document) {
    publish(document, QUIET_MS);
  }

  void closed(String uri) {
    waiting.remove(uri);
    if (!session.features().pullsDiagnostics()) {
      session.client().publishDiagnostics(new PublishDiagnosticsParams(uri, List.of()));
    }
  }

  private void publish(Document document, long delayMs) {
    if (session.features().pullsDiagnostics()) {
      return;
    }
    waiting.put(document.uri(), document);
    session.later(
        () -> {
          // Only the newest version; an earlier one has another task that finds nothing to do.
          if (waiting.remove(document.uri(), document)) {
            session
                .client()
                .publishDiagnostics(
                    new PublishDiagnosticsParams(
                        document.uri(), reports.of(document), document.version()));
          }
        },
        delayMs);
  }
}
