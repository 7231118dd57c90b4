package org.pendant.editors.lsp;

import java.util.List;
import org.eclipse.lsp4j.CodeActionKind;
import org.eclipse.lsp4j.CodeActionOptions;
import org.eclipse.lsp4j.CodeLensOptions;
import org.eclipse.lsp4j.CompletionItemOptions;
import org.eclipse.lsp4j.CompletionOptions;
import org.eclipse.lsp4j.DiagnosticRegistrationOptions;
import org.eclipse.lsp4j.DocumentOnTypeFormattingOptions;
import org.eclipse.lsp4j.RenameOptions;
import org.eclipse.lsp4j.SaveOptions;
import org.eclipse.lsp4j.SemanticTokensServerFull;
import org.eclipse.lsp4j.SemanticTokensWithRegistrationOptions;
import org.eclipse.lsp4j.ServerCapabilities;
import org.eclipse.lsp4j.SignatureHelpOptions;
import org.eclipse.lsp4j.TextDocumentSyncKind;
import org.eclipse.lsp4j.TextDocumentSyncOptions;
import org.eclipse.lsp4j.WorkspaceFoldersOptions;
import org.eclipse.lsp4j.WorkspaceServerCapabilities;
import org.pendant.editors.lsp.provider.CodeActions;
import org.pendant.editors.lsp.provider.DiagnosticAnswers;
import org.pendant.editors.lsp.provider.TokenTypes;
import org.pendant.editors.lsp.text.PositionEncoding;

/** Capabilities: what the server says that it can do; docs/editors.md has the table for people. */
final class Capabilities {
  private Capabilities() {}

  static ServerCapabilities of(PositionEncoding encoding) {
    ServerCapabilities can = new ServerCapabilities();
    can.setPositionEncoding(encoding.word());
    can.setTextDocumentSync(sync());
    can.setDiagnosticProvider(diagnostics());
    can.setCompletionProvider(completion());
    can.setSignatureHelpProvider(new SignatureHelpOptions(List.of("(", ","), List.of(")")));
    can.setHoverProvider(true);
    can.setDefinitionProvider(true);
    can.setReferencesProvider(true);
    can.setDocumentHighlightProvider(true);
    can.setRenameProvider(new RenameOptions(true));
    can.setDocumentSymbolProvider(true);
    can.setWorkspaceSymbolProvider(true);
    can.setFoldingRangeProvider(true);
    can.setSelectionRangeProvider(true);
    can.setDocumentFormattingProvider(true);
    can.setDocumentRangeFormattingProvider(true);
    // The letters that end "end", "else:" and "elif", and the end of a line.
    can.setDocumentOnTypeFormattingProvider(
        new DocumentOnTypeFormattingOptions("\n", List.of("d", ":")));
    can.setSemanticTokensProvider(
        new SemanticTokensWithRegistrationOptions(
            TokenTypes.legend(), new SemanticTokensServerFull(true), true));
    can.setCodeActionProvider(
        new CodeActionOptions(List.of(CodeActionKind.QuickFix, CodeActions.FIX_ALL)));
    can.setCodeLensProvider(new CodeLensOptions(false));
    can.setInlayHintProvider(true);
    can.setCallHierarchyProvider(true);
    can.setWorkspace(workspace());
    return can;
  }

  private static TextDocumentSyncOptions sync() {
    TextDocumentSyncOptions sync = new TextDocumentSyncOptions();
    sync.setOpenClose(true);
    sync.setChange(TextDocumentSyncKind.Incremental);
    sync.setSave(new SaveOptions(false));
    return sync;
  }

  private static DiagnosticRegistrationOptions diagnostics() {
    DiagnosticRegistrationOptions diagnostics = new DiagnosticRegistrationOptions(false, true);
    diagnostics.setIdentifier(DiagnosticAnswers.SOURCE);
    return diagnostics;
  }

  private static CompletionOptions completion() {
    CompletionOptions completion = new CompletionOptions(true, List.of("."));
    CompletionItemOptions item = new CompletionItemOptions();
    item.setLabelDetailsSupport(true);
    completion.setCompletionItem(item);
    return completion;
  }

  private static WorkspaceServerCapabilities workspace() {
    WorkspaceFoldersOptions folders = new WorkspaceFoldersOptions();
    folders.setSupported(true);
    folders.setChangeNotifications(true);
    return new WorkspaceServerCapabilities(folders);
  }
}
