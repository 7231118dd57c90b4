package org.pendant.language.parse;

import java.util.List;
import java.util.Optional;
import org.pendant.language.source.SourceRange;

/** What was read of a text, and what is kept of it for reading a text that differs little. */
public final class ReadText {
  private final ParseResult result;
  private final LexemeTable lexemes;
  private final Optional<TokenTable> tokens;
  private final List<SourceRange> doubtful;

  /**
   * Of a text.
   *
   * @param tokens all of its tokens; empty if they were not all read
   * @param doubtful where the parser complained or would have, and what it mended
   */
  ReadText(
      ParseResult result,
      LexemeTable lexemes,
      Optional<TokenTable> tokens,
      List<SourceRange> doubtful) {
    this.result = result;
    this.lexemes = lexemes;
    this.tokens = tokens;
    this.doubtful = List.copyOf(doubtful);
  }

  /** Its tree and its syntax errors. */
  public ParseResult result() {
    return result;
  }

  /** The lexemes of the whole text in order. */
  public LexemeTable lexemes() {
    return lexemes;
  }

  Optional<TokenTable> tokens() {
    return tokens;
  }

  List<SourceRange> doubtful() {
    return doubtful;
  }
}
