package org.pendant.language.parse;

import java.util.List;
import org.antlr.v4.runtime.RuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenSource;
import org.antlr.v4.runtime.TokenStream;
import org.antlr.v4.runtime.misc.Interval;

/** Token array: all tokens of one text, ended by end-of-file, as a stream for ANTLR's parser. */
final class TokenArray implements TokenStream {
  private final ScriptToken[] tokens;
  private final TokenSource source;
  private int position;

  TokenArray(List<ScriptToken> tokens, TokenSource source) {
    this.tokens = tokens.toArray(ScriptToken[]::new);
    this.source = source;
    for (int i = 0; i < this.tokens.length; i++) {
      this.tokens[i].setTokenIndex(i);
    }
  }

  ScriptToken current() {
    return tokens[position];
  }

  @Override
  public ScriptToken get(int index) {
    return tokens[index];
  }

  @Override
  public Token LT(int distance) {
    if (distance < 0) {
      return position + distance >= 0 ? tokens[position + distance] : null;
    }
    return tokens[Math.min(position + distance - 1, tokens.length - 1)];
  }

  @Override
  public int LA(int distance) {
    int at = distance > 0 ? position + distance - 1 : position + distance;
    return at < 0 ? Token.INVALID_TYPE : tokens[Math.min(at, tokens.length - 1)].getType();
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
        .getText(Interval.of(tokens[interval.a].startOffset(), tokens[interval.b].getStopIndex()));
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
