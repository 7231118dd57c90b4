package org.pendant.language.parse;

import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.RuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenSource;
import org.antlr.v4.runtime.TokenStream;
import org.antlr.v4.runtime.misc.Interval;
import org.pendant.language.source.Source;

/** Token array: all tokens of one text, ended by end-of-file, as a stream for ANTLR's parser. */
final class TokenArray implements TokenStream {
  /** Those of a table are made when they are looked at: most never are. */
  private final ScriptToken[] tokens;

  private final TokenSource source;
  private final Optional<TokenTable> table;
  private final Optional<Source> text;
  private int position;

  TokenArray(List<ScriptToken> tokens, TokenSource source) {
    this.tokens = tokens.toArray(ScriptToken[]::new);
    this.source = source;
    table = Optional.empty();
    text = Optional.empty();
    for (int i = 0; i < this.tokens.length; i++) {
      this.tokens[i].setTokenIndex(i);
    }
  }

  TokenArray(TokenTable table, TokenSource source, Source text) {
    tokens = new ScriptToken[table.size()];
    this.source = source;
    this.table = Optional.of(table);
    this.text = Optional.of(text);
  }

  ScriptToken current() {
    return get(position);
  }

  @Override
  public ScriptToken get(int index) {
    if (tokens[index] == null) {
      tokens[index] = table.orElseThrow().token(index, text.orElseThrow(), source);
    }
    return tokens[index];
  }

  /** The index of the first token that does not begin before {@code offset}; the last if all do. */
  int indexAt(int offset) {
    if (table.isPresent()) {
      return Math.min(table.get().indexAt(offset), tokens.length - 1);
    }
    int low = 0;
    int high = tokens.length - 1;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (tokens[middle].startOffset() < offset) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  @Override
  public Token LT(int distance) {
    if (distance < 0) {
      return position + distance >= 0 ? get(position + distance) : null;
    }
    return get(Math.min(position + distance - 1, tokens.length - 1));
  }

  @Override
  public int LA(int distance) {
    int at = distance > 0 ? position + distance - 1 : position + distance;
    return at < 0 ? Token.INVALID_TYPE : get(Math.min(at, tokens.length - 1)).getType();
  }

  @Override
  public void consume() {
    if (position < tokens.length - 1) {
      position++;
    }
  }

  @Override
  public int mark() {
    return -1;
  }

  @Override
  public void release(int marker) {
    // Every token stays in memory: nothing to free.
  }

  @Override
  public int index() {
    return position;
  }

  @Override
  public void seek(int index) {
    position = index;
  }

  @Override
  public int size() {
    return tokens.length;
  }

  @Override
  public String getSourceName() {
    return source.getSourceName();
  }

  @Override
  public TokenSource getTokenSource() {
    return source;
  }

  @Override
  public String getText(Interval interval) {
    return source
        .getInputStream()
        .getText(Interval.of(get(interval.a).startOffset(), get(interval.b).getStopIndex()));
  }

  @Override
  public String getText() {
    return getText(Interval.of(0, tokens.length - 1));
  }

  @Override
  public String getText(RuleContext context) {
    return getText(context.getSourceInterval());
  }

  @Override
  public String getText(Token from, Token to) {
    return getText(Interval.of(from.getTokenIndex(), to.getTokenIndex()));
  }
}
