package org.pendant.editors.lsp.provider;

import static org.pendant.editors.lsp.provider.AnswerTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.eclipse.lsp4j.DocumentSymbol;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.SymbolInformation;
import org.eclipse.lsp4j.SymbolKind;
import org.eclipse.lsp4j.WorkspaceSymbol;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.service.OutlineItem;

/** Symbols: functions, threads and global variables of texts. */
public final class Symbols {
  private Symbols() {}

  /** Those of one text, inside each other where the client can show that. */
  @SuppressWarnings("deprecation") // what clients without nested symbols understand
  public static List<Either<SymbolInformation, DocumentSymbol>> of(
      Document document, ClientFeatures client) {
    List<OutlineItem> outline = document.analysis().outline();
    if (client.nestedSymbols()) {
      return outline.stream()
          .map(
              item ->
                  Either.<SymbolInformation, DocumentSymbol>forRight(
                      nested(document, item, client)))
          .toList();
    }
    List<Either<SymbolInformation, DocumentSymbol>> flat = new ArrayList<>();
    for (Found found : flat(document)) {
      flat.add(
          Either.forLeft(
              new SymbolInformation(
                  found.name(),
                  found.kind(),
                  new Location(document.uri(), found.range()),
                  found.container())));
    }
    return flat;
  }

  /**
   * A symbol with the one around it.
   *
   * @param container the name of the definition around it; empty at the outermost level
   */
  public record Found(String name, SymbolKind kind, Range range, String container) {}

  /** All symbols of a text one after the other. */
  public static List<Found> flat(Document document) {
    List<Found> found = new ArrayList<>();
    flatten(document, document.analysis().outline(), "", found);
    return List.copyOf(found);
  }

  private static void flatten(
      Document document, List<OutlineItem> items, String container, List<Found> found) {
    for (OutlineItem item : items) {
      found.add(new Found(item.name(), kind(item), document.range(item.range()), container));
      flatten(document, item.children(), item.name(), found);
    }
  }

  /** A symbol for who looks for {@code query} in all texts; whether its letters are in the name. */
  public static boolean matches(Found symbol, String query) {
    String name = symbol.name().toLowerCase(Locale.ROOT);
    int at = 0;
    for (char letter : query.toLowerCase(Locale.ROOT).toCharArray()) {
      at = name.indexOf(letter, at) + 1;
      if (at == 0) {
        return false;
      }
    }
    return true;
  }

  /** A symbol of the text {@code uri}. */
  public static WorkspaceSymbol ofWorkspace(String uri, Found symbol) {
    return new WorkspaceSymbol(
        symbol.name(),
        symbol.kind(),
        Either.forLeft(new Location(uri, symbol.range())),
        symbol.container());
  }

  private static DocumentSymbol nested(Document document, OutlineItem item, ClientFeatures client) {
    DocumentSymbol symbol =
        new DocumentSymbol(
            item.name().isEmpty() ? client.shown(text("noName")) : item.name(),
            kind(item),
            document.range(item.range()),
            document.range(item.nameRange()),
            item.detail());
    symbol.setChildren(
        item.children().stream().map(each -> nested(document, each, client)).toList());
    return symbol;
  }

  private static SymbolKind kind(OutlineItem item) {
    return switch (item.kind()) {
      case FUNCTION -> SymbolKind.Function;
      case SECONDARY -> SymbolKind.Method;
      case THREAD -> SymbolKind.Event;
      case GLOBAL -> SymbolKind.Variable;
    };
  }
}
