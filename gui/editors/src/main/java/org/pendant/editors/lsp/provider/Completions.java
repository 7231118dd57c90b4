package org.pendant.editors.lsp.provider;

import com.google.gson.JsonPrimitive;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionItemKind;
import org.eclipse.lsp4j.CompletionItemLabelDetails;
import org.eclipse.lsp4j.CompletionItemTag;
import org.eclipse.lsp4j.CompletionList;
import org.eclipse.lsp4j.InsertTextFormat;
import org.eclipse.lsp4j.InsertTextMode;
import org.eclipse.lsp4j.MarkupContent;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.service.Completion;
import org.pendant.language.service.Completion.Kind;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.ByteText;

/** Completions: what can be typed at the caret, the likeliest first. */
public final class Completions {
  private Completions() {}

  /** What can be typed at {@code position}. */
  public static CompletionList at(Document document, Position position, ClientFeatures client) {
    List<Completion> found = document.analysis().completions(document.offset(position));
    List<CompletionItem> items = new ArrayList<>(found.size());
    for (Completion completion : found) {
      items.add(item(document, completion, items.size(), client));
    }
    // The list is of the word as it is typed so far: with another it is another one.
    boolean typed =
        !found.isEmpty() && found.getFirst().replaced().end() > found.getFirst().replaced().start();
    return new CompletionList(typed, items);
  }

  private static CompletionItem item(
      Document document, Completion completion, int rank, ClientFeatures client) {
    CompletionItem item = new CompletionItem(decoded(completion.label()));
    item.setKind(kind(completion.kind()));
    item.setSortText(sortText(rank));
    item.setFilterText(decoded(completion.label()));
    String detail = decoded(completion.detail());
    if (completion.kind() == Kind.KEYWORD || completion.kind() == Kind.SNIPPET) {
      detail = client.shown(detail);
    }
    if (!detail.isEmpty()) {
      item.setDetail(detail);
      CompletionItemLabelDetails beside = new CompletionItemLabelDetails();
      beside.setDescription(detail);
      item.setLabelDetails(completion.kind() == Kind.BUILTIN ? null : beside);
    }
    if (completion.kind() == Kind.BUILTIN || completion.kind() == Kind.METHOD) {
      // Explained when the client asks: there are several hundred.
      item.setData(new JsonPrimitive(document.uri()));
      if (isDeprecated(document.analysis().catalogue(), completion)) {
        item.setTags(List.of(CompletionItemTag.Deprecated));
      }
    } else if (!completion.documentation().isEmpty()) {
      item.setDocumentation(decoded(completion.documentation()));
    }
    String text =
        client.snippets() ? Snippets.of(completion) : ByteText.decoded(completion.insert());
    item.setInsertTextFormat(
        client.snippets() ? InsertTextFormat.Snippet : InsertTextFormat.PlainText);
    // The text has the indentation of its line already.
    item.setInsertTextMode(InsertTextMode.AsIs);
    item.setTextEdit(Either.forLeft(new TextEdit(document.range(completion.replaced()), text)));
    return item;
  }

  /** Five digits, which sort as numbers do; there may be hundreds for each letter that is typed. */
  private static String sortText(int rank) {
    String digits = Integer.toString(rank);
    return "0".repeat(Math.max(0, 5 - digits.length())) + digits;
  }

  private static boolean isDeprecated(Catalogue catalogue, Completion completion) {
    return completion.kind() == Kind.BUILTIN
        && catalogue
            .function(completion.label())
            .filter(each -> !each.deprecated().isEmpty())
            .isPresent();
  }

  /** The text that {@code item} was offered for, if its explanation is still to come. */
  public static Optional<String> documentOf(CompletionItem item) {
    return item.getData() instanceof JsonPrimitive data && data.isString()
        ? Optional.of(data.getAsString())
        : Optional.empty();
  }

  /** Adds the explanation of a function of the catalogue. */
  public static CompletionItem resolved(
      CompletionItem item, Optional<Catalogue> catalogue, ClientFeatures client) {
    catalogue
        .flatMap(all -> Explanations.named(all, item.getLabel(), client))
        .ifPresent(
            text ->
                item.setDocumentation(
                    client.markdown()
                        ? Either.forRight(new MarkupContent("markdown", text.markdown()))
                        : Either.forLeft(text.plain())));
    return item;
  }

  private static CompletionItemKind kind(Kind kind) {
    return switch (kind) {
      case ARGUMENT, PARAMETER, LOCAL, GLOBAL -> CompletionItemKind.Variable;
      case MEMBER -> CompletionItemKind.Field;
      case METHOD -> CompletionItemKind.Method;
      case FUNCTION, BUILTIN -> CompletionItemKind.Function;
      case THREAD -> CompletionItemKind.Event;
      case KEYWORD -> CompletionItemKind.Keyword;
      case SNIPPET -> CompletionItemKind.Snippet;
    };
  }

  private static String decoded(String bytes) {
    return ByteText.decoded(bytes);
  }
}
