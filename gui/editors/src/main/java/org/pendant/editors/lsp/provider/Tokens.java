package org.pendant.editors.lsp.provider;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.SemanticTokensEdit;
import org.pendant.editors.lsp.text.Document;
import org.pendant.editors.lsp.text.TextPositions;
import org.pendant.language.service.HighlightToken;
import org.pendant.language.service.HighlightToken.Style;
import org.pendant.language.service.Occurrence;
import org.pendant.language.source.SourceRange;

/** Tokens: the colours of a text, five numbers each, as the protocol writes them. */
public final class Tokens {
  private static final int NUMBERS_EACH = 5;

  private final Document document;
  private final Set<Integer> declared = new HashSet<>();
  private final List<Integer> numbers = new ArrayList<>();
  private int line;
  private int character;

  private Tokens(Document document) {
    this.document = document;
    document.analysis().occurrences().stream()
        .filter(each -> each.role() == Occurrence.Role.DECLARE)
        .forEach(each -> declared.add(each.range().start()));
  }

  /** Those of the whole text. */
  public static List<Integer> of(Document document) {
    return of(document, new SourceRange(0, document.source().text().length()));
  }

  /** Those that overlap {@code range}. */
  public static List<Integer> of(Document document, Range range) {
    return of(document, document.positions().range(range));
  }

  private static List<Integer> of(Document document, SourceRange range) {
    Tokens tokens = new Tokens(document);
    for (HighlightToken token : document.analysis().highlighting()) {
      if (token.end() > range.start() && token.start() < range.end()) {
        tokens.add(token);
      }
    }
    return List.copyOf(tokens.numbers);
  }

  private void add(HighlightToken token) {
    int type = TokenTypes.type(token.style());
    if (type < 0) {
      return;
    }
    int modifiers =
        (token.style() == Style.BUILTIN ? TokenTypes.DEFAULT_LIBRARY : 0)
            | (declared.contains(token.start()) ? TokenTypes.DECLARATION : 0);
    TextPositions positions = document.positions();
    Position end = positions.position(token.end());
    Position start = positions.position(token.start());
    // A token may not go over the end of a line.
    while (start.getLine() < end.getLine()) {
      int lineEnd = positions.lineEnd(start.getLine());
      add(start, positions.position(lineEnd), type, modifiers);
      start = new Position(start.getLine() + 1, 0);
    }
    add(start, end, type, modifiers);
  }

  private void add(Position start, Position end, int type, int modifiers) {
    int length = end.getCharacter() - start.getCharacter();
    if (length <= 0) {
      return;
    }
    int lines = start.getLine() - line;
    numbers.add(lines);
    numbers.add(lines == 0 ? start.getCharacter() - character : start.getCharacter());
    numbers.add(length);
    numbers.add(type);
    numbers.add(modifiers);
    line = start.getLine();
    character = start.getCharacter();
  }

  /** What makes {@code after} of {@code before}: one edit of whole tokens, or none. */
  public static List<SemanticTokensEdit> edits(List<Integer> before, List<Integer> after) {
    int shorter = Math.min(before.size(), after.size());
    int same = 0;
    while (same < shorter && before.get(same).equals(after.get(same))) {
      same++;
    }
    same -= same % NUMBERS_EACH;
    int tail = 0;
    while (tail < shorter - same
        && before.get(before.size() - 1 - tail).equals(after.get(after.size() - 1 - tail))) {
      tail++;
    }
    tail -= tail % NUMBERS_EACH;
    if (same == before.size() && same == after.size()) {
      return List.of();
    }
    return List.of(
        new SemanticTokensEdit(
            same,
            before.size() - tail - same,
            List.copyOf(after.subList(same, after.size() - tail))));
  }
}
