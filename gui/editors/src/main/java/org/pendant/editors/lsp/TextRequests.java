package org.pendant.editors.lsp;

import static org.pendant.editors.lsp.LanguageServerTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.eclipse.lsp4j.CallHierarchyIncomingCall;
import org.eclipse.lsp4j.CallHierarchyIncomingCallsParams;
import org.eclipse.lsp4j.CallHierarchyItem;
import org.eclipse.lsp4j.CallHierarchyOutgoingCall;
import org.eclipse.lsp4j.CallHierarchyOutgoingCallsParams;
import org.eclipse.lsp4j.CallHierarchyPrepareParams;
import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.CodeLensParams;
import org.eclipse.lsp4j.Command;
import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionList;
import org.eclipse.lsp4j.CompletionParams;
import org.eclipse.lsp4j.DefinitionParams;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.DidCloseTextDocumentParams;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.DidSaveTextDocumentParams;
import org.eclipse.lsp4j.DocumentDiagnosticParams;
import org.eclipse.lsp4j.DocumentDiagnosticReport;
import org.eclipse.lsp4j.DocumentFormattingParams;
import org.eclipse.lsp4j.DocumentHighlight;
import org.eclipse.lsp4j.DocumentHighlightParams;
import org.eclipse.lsp4j.DocumentOnTypeFormattingParams;
import org.eclipse.lsp4j.DocumentRangeFormattingParams;
import org.eclipse.lsp4j.DocumentSymbol;
import org.eclipse.lsp4j.DocumentSymbolParams;
import org.eclipse.lsp4j.FoldingRange;
import org.eclipse.lsp4j.FoldingRangeRequestParams;
import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.InlayHint;
import org.eclipse.lsp4j.InlayHintParams;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.LocationLink;
import org.eclipse.lsp4j.PrepareRenameDefaultBehavior;
import org.eclipse.lsp4j.PrepareRenameParams;
import org.eclipse.lsp4j.PrepareRenameResult;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.ReferenceParams;
import org.eclipse.lsp4j.RenameParams;
import org.eclipse.lsp4j.SelectionRange;
import org.eclipse.lsp4j.SelectionRangeParams;
import org.eclipse.lsp4j.SemanticTokens;
import org.eclipse.lsp4j.SemanticTokensDelta;
import org.eclipse.lsp4j.SemanticTokensDeltaParams;
import org.eclipse.lsp4j.SemanticTokensParams;
import org.eclipse.lsp4j.SemanticTokensRangeParams;
import org.eclipse.lsp4j.SignatureHelp;
import org.eclipse.lsp4j.SignatureHelpParams;
import org.eclipse.lsp4j.SymbolInformation;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextDocumentItem;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.WorkspaceEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.jsonrpc.messages.Either3;
import org.eclipse.lsp4j.services.TextDocumentService;
import org.pendant.editors.lsp.ServerSettings.DryRunTime;
import org.pendant.editors.lsp.provider.CallHierarchies;
import org.pendant.editors.lsp.provider.CodeActions;
import org.pendant.editors.lsp.provider.CodeLenses;
import org.pendant.editors.lsp.provider.Completions;
import org.pendant.editors.lsp.provider.DryRunAnswers;
import org.pendant.editors.lsp.provider.Formatting;
import org.pendant.editors.lsp.provider.HintSettings;
import org.pendant.editors.lsp.provider.Hovers;
import org.pendant.editors.lsp.provider.InlayHints;
import org.pendant.editors.lsp.provider.Names;
import org.pendant.editors.lsp.provider.RequestRefusal;
import org.pendant.editors.lsp.provider.SignatureHelps;
import org.pendant.editors.lsp.provider.Structure;
import org.pendant.editors.lsp.provider.Symbols;
import org.pendant.editors.lsp.provider.Tokens;
import org.pendant.editors.lsp.text.Document;

/**
 * Text requests: what the protocol has under {@code textDocument/}. Each request is answered from
 * the version of the text that the client had when it asked.
 */
final class TextRequests implements TextDocumentService {
  /** Time without a change after which a text runs dry, where that is wanted. */
  private static final long QUIET_MS = 1000;

  private final ServerSession session;
  private final DryRuns dryRuns;
  private final DiagnosticPublisher publisher;
  private final DiagnosticReports reports;
  private final TokenMemory tokens = new TokenMemory();

  TextRequests(ServerSession session) {
    this.session = session;
    dryRuns = new DryRuns(session, this::dryRunOver);
    reports = new DiagnosticReports(session, dryRuns);
    publisher = new DiagnosticPublisher(session, reports);
  }

  /** The runs of the texts. */
  DryRuns dryRuns() {
    return dryRuns;
  }

  private void dryRunOver(Document document) {
    publisher.learned(document);
    if (session.features().refreshesLenses()) {
      var _ = session.client().refreshCodeLenses();
    }
    if (session.features().refreshesHints()) {
      var _ = session.client().refreshInlayHints();
    }
  }

  /** Has {@code answer} given about the newest version of {@code asked}. */
  private <R> CompletableFuture<R> about(
      TextDocumentIdentifier asked, Function<Document, R> answer) {
    return about(asked.getUri(), answer);
  }

  private <R> CompletableFuture<R> about(String uri, Function<Document, R> answer) {
    Optional<Document> document = session.documents().find(uri);
    return document.isEmpty()
        ? CompletableFuture.failedFuture(RequestRefusal.ofParameters(text("notOpen", uri)))
        : session.answer(cancelled -> answer.apply(document.get()));
  }

  // --- texts

  @Override
  public void didOpen(DidOpenTextDocumentParams opened) {
    TextDocumentItem item = opened.getTextDocument();
    session.attempt(
        () -> {
          Document document =
              session.documents().open(item.getUri(), item.getVersion(), item.getText());
          publisher.opened(document);
          if (session.settings().dryRun() != DryRunTime.OFF) {
            dryRuns.ask(document);
          }
        });
  }

  @Override
  public void didChange(DidChangeTextDocumentParams changed) {
    session.attempt(
        () -> {
          Document document =
              session
                  .documents()
                  .change(
                      changed.getTextDocument().getUri(),
                      changed.getTextDocument().getVersion(),
                      changed.getContentChanges());
          publisher.changed(document);
          if (session.settings().dryRun() == DryRunTime.ON_CHANGE) {
            session.later(() -> askIfNewest(document), QUIET_MS);
          }
        });
  }

  @Override
  public void didClose(DidCloseTextDocumentParams closed) {
    String uri = closed.getTextDocument().getUri();
    session.documents().close(uri);
    tokens.forget(uri);
    dryRuns.forget(uri);
    publisher.closed(uri);
  }

  @Override
  public void didSave(DidSaveTextDocumentParams saved) {
    session.documents().forgetImports();
    if (session.settings().dryRun() != DryRunTime.OFF) {
      session.documents().find(saved.getTextDocument().getUri()).ifPresent(dryRuns::ask);
    }
  }

  private void askIfNewest(Document document) {
    session.documents().find(document.uri()).filter(document::equals).ifPresent(dryRuns::ask);
  }

  @Override
  public CompletableFuture<DocumentDiagnosticReport> diagnostic(DocumentDiagnosticParams asked) {
    if (session.documents().find(asked.getTextDocument().getUri()).isEmpty()) {
      // asked just before it was closed: editors would show a refusal to people
      return CompletableFuture.completedFuture(DiagnosticReports.nothing());
    }
    return about(
        asked.getTextDocument(),
        document -> reports.report(document, Optional.ofNullable(asked.getPreviousResultId())));
  }

  // --- typing

  @Override
  public CompletableFuture<Either<List<CompletionItem>, CompletionList>> completion(
      CompletionParams asked) {
    return about(
        asked.getTextDocument(),
        document ->
            Either.forRight(Completions.at(document, asked.getPosition(), session.features())));
  }

  @Override
  public CompletableFuture<CompletionItem> resolveCompletionItem(CompletionItem item) {
    return session.answer(
        cancelled ->
            Completions.resolved(
                item,
                Completions.documentOf(item)
                    .flatMap(session.documents()::find)
                    .map(document -> document.analysis().catalogue()),
                session.features()));
  }

  @Override
  public CompletableFuture<SignatureHelp> signatureHelp(SignatureHelpParams asked) {
    return about(
        asked.getTextDocument(),
        document -> SignatureHelps.at(document, asked.getPosition()).orElse(null));
  }

  @Override
  public CompletableFuture<List<? extends TextEdit>> formatting(DocumentFormattingParams asked) {
    return about(asked.getTextDocument(), document -> Formatting.of(document, asked.getOptions()));
  }

  @Override
  public CompletableFuture<List<? extends TextEdit>> rangeFormatting(
      DocumentRangeFormattingParams asked) {
    return about(
        asked.getTextDocument(),
        document -> Formatting.of(document, asked.getRange(), asked.getOptions()));
  }

  @Override
  public CompletableFuture<List<? extends TextEdit>> onTypeFormatting(
      DocumentOnTypeFormattingParams asked) {
    return about(
        asked.getTextDocument(),
        document -> Formatting.onType(document, asked.getPosition(), asked.getOptions()));
  }

  @Override
  public CompletableFuture<List<Either<Command, CodeAction>>> codeAction(CodeActionParams asked) {
    return about(
        asked.getTextDocument(),
        document ->
            CodeActions.of(document, asked, session.features()).stream()
                .map(Either::<Command, CodeAction>forRight)
                .toList());
  }

  // --- names

  @Override
  public CompletableFuture<Hover> hover(HoverParams asked) {
    return about(
        asked.getTextDocument(),
        document -> Hovers.at(document, asked.getPosition(), session.features()).orElse(null));
  }

  @Override
  public CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
      definition(DefinitionParams asked) {
    return about(
        asked.getTextDocument(),
        document ->
            Either.forLeft(Names.definition(document, asked.getPosition()).stream().toList()));
  }

  @Override
  public CompletableFuture<List<? extends Location>> references(ReferenceParams asked) {
    return about(
        asked.getTextDocument(),
        document ->
            Names.references(
                document, asked.getPosition(), asked.getContext().isIncludeDeclaration()));
  }

  @Override
  public CompletableFuture<List<? extends DocumentHighlight>> documentHighlight(
      DocumentHighlightParams asked) {
    return about(
        asked.getTextDocument(), document -> Names.highlights(document, asked.getPosition()));
  }

  @Override
  public CompletableFuture<Either3<Range, PrepareRenameResult, PrepareRenameDefaultBehavior>>
      prepareRename(PrepareRenameParams asked) {
    return about(
        asked.getTextDocument(),
        document ->
            Names.renamable(document, asked.getPosition())
                .map(Either3::<Range, PrepareRenameResult, PrepareRenameDefaultBehavior>forSecond)
                .orElse(null));
  }

  @Override
  public CompletableFuture<WorkspaceEdit> rename(RenameParams asked) {
    return about(
        asked.getTextDocument(),
        document -> Names.renamed(document, asked.getPosition(), asked.getNewName()));
  }

  @Override
  public CompletableFuture<List<CallHierarchyItem>> prepareCallHierarchy(
      CallHierarchyPrepareParams asked) {
    return about(
        asked.getTextDocument(), document -> CallHierarchies.at(document, asked.getPosition()));
  }

  @Override
  public CompletableFuture<List<CallHierarchyIncomingCall>> callHierarchyIncomingCalls(
      CallHierarchyIncomingCallsParams asked) {
    return about(
        asked.getItem().getUri(), document -> CallHierarchies.incoming(document, asked.getItem()));
  }

  @Override
  public CompletableFuture<List<CallHierarchyOutgoingCall>> callHierarchyOutgoingCalls(
      CallHierarchyOutgoingCallsParams asked) {
    return about(
        asked.getItem().getUri(), document -> CallHierarchies.outgoing(document, asked.getItem()));
  }

  // --- the text as a whole

  @Override
  public CompletableFuture<List<Either<SymbolInformation, DocumentSymbol>>> documentSymbol(
      DocumentSymbolParams asked) {
    return about(asked.getTextDocument(), document -> Symbols.of(document, session.features()));
  }

  @Override
  public CompletableFuture<List<FoldingRange>> foldingRange(FoldingRangeRequestParams asked) {
    return about(asked.getTextDocument(), Structure::folding);
  }

  @Override
  public CompletableFuture<List<SelectionRange>> selectionRange(SelectionRangeParams asked) {
    return about(
        asked.getTextDocument(),
        document ->
            new ArrayList<>(
                asked.getPositions().stream()
                    .map(position -> Structure.selection(document, position))
                    .toList()));
  }

  @Override
  public CompletableFuture<List<? extends CodeLens>> codeLens(CodeLensParams asked) {
    return about(
        asked.getTextDocument(),
        document ->
            CodeLenses.of(
                document,
                dryRuns.of(document).flatMap(DryRunAnswers::duration),
                session.features()));
  }

  @Override
  public CompletableFuture<List<InlayHint>> inlayHint(InlayHintParams asked) {
    return about(asked.getTextDocument(), document -> hints(document, asked.getRange()));
  }

  private List<InlayHint> hints(Document document, Range range) {
    HintSettings settings = session.settings().hints();
    List<InlayHint> hints =
        new ArrayList<>(InlayHints.of(document, range, settings, session.features()));
    if (settings.durations()) {
      dryRuns
          .of(document)
          .ifPresent(
              result ->
                  hints.addAll(DryRunAnswers.hints(document, range, result, session.features())));
    }
    return hints;
  }

  @Override
  public CompletableFuture<SemanticTokens> semanticTokensFull(SemanticTokensParams asked) {
    return about(
        asked.getTextDocument(),
        document -> {
          List<Integer> numbers = Tokens.of(document);
          return new SemanticTokens(tokens.keep(document.uri(), numbers), numbers);
        });
  }

  @Override
  public CompletableFuture<Either<SemanticTokens, SemanticTokensDelta>> semanticTokensFullDelta(
      SemanticTokensDeltaParams asked) {
    return about(
        asked.getTextDocument(),
        document -> {
          Optional<List<Integer>> before = tokens.find(document.uri(), asked.getPreviousResultId());
          List<Integer> numbers = Tokens.of(document);
          String id = tokens.keep(document.uri(), numbers);
          return before.isPresent()
              ? Either.forRight(new SemanticTokensDelta(Tokens.edits(before.get(), numbers), id))
              : Either.forLeft(new SemanticTokens(id, numbers));
        });
  }

  @Override
  public CompletableFuture<SemanticTokens> semanticTokensRange(SemanticTokensRangeParams asked) {
    return about(
        asked.getTextDocument(),
        document -> new SemanticTokens(Tokens.of(document, asked.getRange())));
  }
}
