package org.pendant.editors.dap;

import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.eclipse.lsp4j.debug.CompletionItem;
import org.eclipse.lsp4j.debug.CompletionItemType;
import org.eclipse.lsp4j.debug.CompletionsArguments;
import org.eclipse.lsp4j.debug.CompletionsResponse;
import org.pendant.language.service.CharacterOffsets;
import org.pendant.language.service.Completion;
import org.pendant.language.service.GuestExpression;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.ByteText;

/** Requests about what may be typed where an expression is expected. */
final class CompletionRequests {
  /** Offers of one answer. */
  private static final int MAX_OFFERS = 200;

  /** Longer texts are no expressions that anybody types. */
  private static final int MAX_LENGTH = 10_000;

  private final DebugSession session;
  private final Catalogue catalogue;

  CompletionRequests(DebugSession session, Catalogue catalogue) {
    this.session = session;
    this.catalogue = catalogue;
  }

  CompletionsResponse complete(CompletionsArguments asked) {
    String all = Objects.requireNonNullElse(asked.getText(), "");
    int lineStart = lineStart(all, asked.getLine());
    int lineEnd = all.indexOf('\n', lineStart) < 0 ? all.length() : all.indexOf('\n', lineStart);
    String text = all.substring(lineStart, Math.min(lineEnd, lineStart + MAX_LENGTH));
    int caret = Math.min(session.form().fromColumn(asked.getColumn()) - 1, text.length());
    int word = wordStart(text, caret);
    int line = line(asked.getFrameId());
    List<Completion> found =
        GuestExpression.of(
                session.program().text().source(), catalogue, line, ByteText.asBytes(text))
            .completions(CharacterOffsets.of(text).toByte(caret));
    CompletionsResponse response = new CompletionsResponse();
    response.setTargets(
        IntStream.range(0, Math.min(found.size(), MAX_OFFERS))
            .mapToObj(i -> told(found.get(i), i, word, caret))
            .toArray(CompletionItem[]::new));
    return response;
  }

  private int lineStart(String text, Integer line) {
    int start = 0;
    int before = line == null ? 0 : session.form().fromLine(line) - 1;
    for (int i = 0; i < before && text.indexOf('\n', start) >= 0; i++) {
      start = text.indexOf('\n', start) + 1;
    }
    return start;
  }

  private static int wordStart(String text, int caret) {
    int start = caret;
    while (start > 0
        && (Character.isLetterOrDigit(text.charAt(start - 1)) || text.charAt(start - 1) == '_')) {
      start--;
    }
    return start;
  }

  /** The line of the program at which names mean what they mean in the call. */
  private int line(Integer frameId) {
    if (frameId == null || frameId == 0 || session.view().isEmpty()) {
      return 1;
    }
    References.Frame frame = session.references().frame(frameId);
    return session.stopped().threads().stream()
        .filter(each -> each.id() == frame.thread())
        .map(each -> each.stack().get(each.stack().size() - frame.depth()).line())
        .findFirst()
        .orElse(1);
  }

  private CompletionItem told(Completion found, int place, int word, int caret) {
    CompletionItem told = new CompletionItem();
    told.setLabel(ByteText.decoded(found.label()));
    told.setText(ByteText.decoded(found.insert()));
    // the likeliest first
    told.setSortText(String.format("%04d", place));
    if (!found.detail().isEmpty()) {
      told.setDetail(ByteText.decoded(found.detail()));
    }
    told.setType(type(found.kind()));
    told.setStart(session.form().column(word + 1));
    told.setLength(caret - word);
    told.setSelectionStart(ByteText.decoded(found.insert().substring(0, found.caret())).length());
    told.setSelectionLength(0);
    return told;
  }

  private static CompletionItemType type(Completion.Kind kind) {
    return switch (kind) {
      case ARGUMENT -> CompletionItemType.PROPERTY;
      case MEMBER -> CompletionItemType.FIELD;
      case METHOD -> CompletionItemType.METHOD;
      case PARAMETER, LOCAL, GLOBAL -> CompletionItemType.VARIABLE;
      case FUNCTION, THREAD, BUILTIN -> CompletionItemType.FUNCTION;
      case KEYWORD -> CompletionItemType.KEYWORD;
      case SNIPPET -> CompletionItemType.SNIPPET;
    };
  }
}
