package org.pendant.editors.lsp;

import static org.pendant.editors.lsp.LanguageServerTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.DidChangeConfigurationParams;
import org.eclipse.lsp4j.DidChangeWatchedFilesParams;
import org.eclipse.lsp4j.DidChangeWorkspaceFoldersParams;
import org.eclipse.lsp4j.ProgressParams;
import org.eclipse.lsp4j.SymbolInformation;
import org.eclipse.lsp4j.WorkDoneProgressBegin;
import org.eclipse.lsp4j.WorkDoneProgressEnd;
import org.eclipse.lsp4j.WorkDoneProgressNotification;
import org.eclipse.lsp4j.WorkspaceDiagnosticParams;
import org.eclipse.lsp4j.WorkspaceDiagnosticReport;
import org.eclipse.lsp4j.WorkspaceDocumentDiagnosticReport;
import org.eclipse.lsp4j.WorkspaceFullDocumentDiagnosticReport;
import org.eclipse.lsp4j.WorkspaceSymbol;
import org.eclipse.lsp4j.WorkspaceSymbolParams;
import org.eclipse.lsp4j.WorkspaceUnchangedDocumentDiagnosticReport;
import org.eclipse.lsp4j.jsonrpc.CancelChecker;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.services.WorkspaceService;
import org.pendant.editors.lsp.provider.Symbols;
import org.pendant.editors.lsp.text.Document;

/** Workspace requests: what the protocol has under {@code workspace/}, about all files at once. */
final class WorkspaceRequests implements WorkspaceService {
  /** The most symbols that are found at once. */
  private static final int MAX_SYMBOLS = 1000;

  private final ServerSession session;
  private final WorkspaceFiles files;
  private final Runnable settingsChanged;

  /**
   * Requests about {@code files}.
   *
   * @param settingsChanged asks the client for its settings anew
   */
  WorkspaceRequests(ServerSession session, WorkspaceFiles files, Runnable settingsChanged) {
    this.session = session;
    this.files = files;
    this.settingsChanged = settingsChanged;
  }

  @Override
  public void didChangeConfiguration(DidChangeConfigurationParams changed) {
    if (session.features().configuration()) {
      settingsChanged.run();
    } else {
      session.use(ServerSettings.of(changed.getSettings()));
    }
  }

  @Override
  public void didChangeWatchedFiles(DidChangeWatchedFilesParams changed) {
    // Files are compared with what is known of them whenever something is asked.
    if (session.features().refreshesDiagnostics()) {
      var _ = session.client().refreshDiagnostics();
    }
  }

  @Override
  public void didChangeWorkspaceFolders(DidChangeWorkspaceFoldersParams changed) {
    changed.getEvent().getRemoved().forEach(folder -> files.remove(folder.getUri()));
    changed.getEvent().getAdded().forEach(folder -> files.add(folder.getUri()));
  }

  @Override
  public CompletableFuture<
          Either<List<? extends SymbolInformation>, List<? extends WorkspaceSymbol>>>
      symbol(WorkspaceSymbolParams asked) {
    return session.answerOfWorkspace(
        cancelled -> {
          List<WorkspaceSymbol> found = new ArrayList<>();
          for (WorkspaceFiles.Facts facts : all(cancelled)) {
            facts.symbols().stream()
                .filter(symbol -> Symbols.matches(symbol, asked.getQuery()))
                .limit(Math.max(0, MAX_SYMBOLS - found.size()))
                .forEach(symbol -> found.add(Symbols.ofWorkspace(facts.uri(), symbol)));
          }
          return Either.forRight(found);
        });
  }

  @Override
  public CompletableFuture<WorkspaceDiagnosticReport> diagnostic(WorkspaceDiagnosticParams asked) {
    Map<String, String> previous = new HashMap<>();
    asked.getPreviousResultIds().forEach(each -> previous.put(each.getUri(), each.getValue()));
    return session.answerOfWorkspace(
        cancelled -> {
          begin(asked.getWorkDoneToken());
          try {
            List<WorkspaceDocumentDiagnosticReport> reports = new ArrayList<>();
            for (WorkspaceFiles.Facts facts : all(cancelled)) {
              reports.add(report(facts, previous.get(facts.uri())));
            }
            return new WorkspaceDiagnosticReport(reports);
          } finally {
            end(asked.getWorkDoneToken());
          }
        });
  }

  private WorkspaceDocumentDiagnosticReport report(WorkspaceFiles.Facts facts, String previous) {
    Integer version = session.documents().find(facts.uri()).map(Document::version).orElse(null);
    if (facts.id().equals(previous)) {
      return new WorkspaceDocumentDiagnosticReport(
          new WorkspaceUnchangedDocumentDiagnosticReport(facts.id(), facts.uri(), version));
    }
    WorkspaceFullDocumentDiagnosticReport report =
        new WorkspaceFullDocumentDiagnosticReport(facts.diagnostics(), facts.uri(), version);
    report.setResultId(facts.id());
    return new WorkspaceDocumentDiagnosticReport(report);
  }

  private List<WorkspaceFiles.Facts> all(CancelChecker cancelled) {
    return files.facts(cancelled);
  }

  private void begin(Either<String, Integer> token) {
    WorkDoneProgressBegin begin = new WorkDoneProgressBegin();
    begin.setTitle(session.features().shown(text("checkingFiles")));
    tell(token, begin);
  }

  private void end(Either<String, Integer> token) {
    tell(token, new WorkDoneProgressEnd());
  }

  private void tell(Either<String, Integer> token, WorkDoneProgressNotification progress) {
    if (token != null) {
      session.client().notifyProgress(new ProgressParams(token, Either.forLeft(progress)));
    }
  }
}
