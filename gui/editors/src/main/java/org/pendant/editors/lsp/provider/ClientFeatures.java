package org.pendant.editors.lsp.provider;

import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.CompletionCapabilities;
import org.eclipse.lsp4j.CompletionItemCapabilities;
import org.eclipse.lsp4j.HoverCapabilities;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.MarkupKind;
import org.eclipse.lsp4j.TextDocumentClientCapabilities;
import org.eclipse.lsp4j.WindowClientCapabilities;
import org.eclipse.lsp4j.WorkspaceClientCapabilities;
import org.pendant.editors.wire.ClientLanguages;
import org.pendant.text.MessageTranslator;

/**
 * Client features: what the client has said that it can do, as far as answers depend on it.
 *
 * @param snippets whether text to insert may have tab stops
 * @param markdown whether explanations may be marked up
 * @param pullsDiagnostics whether it asks for diagnostics by itself
 * @param nestedSymbols whether symbols of a document may have children
 * @param configuration whether it can be asked for its settings
 * @param progress whether it shows the progress of what the server does
 * @param refreshesDiagnostics whether it can be told to ask for diagnostics anew
 * @param refreshesLenses whether it can be told to ask for code lenses anew
 * @param refreshesHints whether it can be told to ask for inlay hints anew
 * @param language says what people read in their language
 */
public record ClientFeatures(
    boolean snippets,
    boolean markdown,
    boolean pullsDiagnostics,
    boolean nestedSymbols,
    boolean configuration,
    boolean progress,
    boolean refreshesDiagnostics,
    boolean refreshesLenses,
    boolean refreshesHints,
    MessageTranslator language) {
  /** A client that can do as little as the protocol asks for. */
  public static final ClientFeatures LEAST =
      new ClientFeatures(
          false, false, false, false, false, false, false, false, false, ClientLanguages.ENGLISH);

  /** What a client says of itself. */
  public static ClientFeatures of(InitializeParams told) {
    ClientCapabilities client = told.getCapabilities();
    Optional<TextDocumentClientCapabilities> text =
        Optional.ofNullable(client).map(ClientCapabilities::getTextDocument);
    Optional<WorkspaceClientCapabilities> workspace =
        Optional.ofNullable(client).map(ClientCapabilities::getWorkspace);
    Optional<WindowClientCapabilities> window =
        Optional.ofNullable(client).map(ClientCapabilities::getWindow);
    return new ClientFeatures(
        yes(
            text.map(TextDocumentClientCapabilities::getCompletion)
                .map(CompletionCapabilities::getCompletionItem)
                .map(CompletionItemCapabilities::getSnippetSupport)),
        text.map(TextDocumentClientCapabilities::getHover)
            .map(HoverCapabilities::getContentFormat)
            .map(formats -> prefersMarkdown(formats))
            .orElse(false),
        text.map(TextDocumentClientCapabilities::getDiagnostic).isPresent(),
        yes(
            text.map(TextDocumentClientCapabilities::getDocumentSymbol)
                .map(each -> each.getHierarchicalDocumentSymbolSupport())),
        yes(workspace.map(WorkspaceClientCapabilities::getConfiguration)),
        yes(window.map(WindowClientCapabilities::getWorkDoneProgress)),
        yes(
            workspace
                .map(WorkspaceClientCapabilities::getDiagnostics)
                .map(each -> each.getRefreshSupport())),
        yes(
            workspace
                .map(WorkspaceClientCapabilities::getCodeLens)
                .map(each -> each.getRefreshSupport())),
        yes(
            workspace
                .map(WorkspaceClientCapabilities::getInlayHint)
                .map(each -> each.getRefreshSupport())),
        ClientLanguages.of(told.getLocale()));
  }

  /** A message as its people read it. */
  public String shown(String message) {
    return language.shown(message);
  }

  private static boolean prefersMarkdown(List<String> formats) {
    int markdown = formats.indexOf(MarkupKind.MARKDOWN);
    int plain = formats.indexOf(MarkupKind.PLAINTEXT);
    return markdown >= 0 && (plain < 0 || markdown < plain);
  }

  private static boolean yes(Optional<Boolean> told) {
    return told.orElse(false);
  }
}
