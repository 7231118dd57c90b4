package org.pendant.language.parse;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenFactory;
import org.antlr.v4.runtime.TokenSource;
import org.antlr.v4.runtime.misc.Interval;
import org.antlr.v4.runtime.misc.Pair;
import org.pendant.language.source.SourceRange;

/**
 * Token that knows how it stands on its line and among brackets. Large programs have millions, so
 * it keeps less than ANTLR's own class does.
 */
final class ScriptToken implements Token {
  /** The factory for ANTLR's lexer. */
  static final TokenFactory<ScriptToken> FACTORY =
      new TokenFactory<>() {
        @Override
        public ScriptToken create(
            Pair<TokenSource, CharStream> source,
            int type,
            String text,
            int channel,
            int start,
            int stop,
            int line,
            int column) {
          return new ScriptToken(source.a, type, start, stop, line);
        }

        @Override
        public ScriptToken create(int type, String text) {
          throw new UnsupportedOperationException("tokens come from a source: " + text);
        }
      };

  private final TokenSource source;
  private final int start;
  private final int stop;
  private final int line;
  private int type;
  private int index = -1;
  private boolean firstOnLine;
  private short depth;

  ScriptToken(TokenSource source, int type, int start, int stop, int line) {
    this.source = source;
    this.type = type;
    this.start = start;
    this.stop = stop;
    this.line = line;
  }

  /** A token that the text lacks, standing empty where {@code next} begins. */
  static ScriptToken missing(int type, ScriptToken next) {
    ScriptToken token = new ScriptToken(next.source, type, next.start, next.start - 1, next.line);
    token.depth = next.depth;
    return token;
  }

  void place(boolean isFirstOnLine, int bracketDepth) {
    firstOnLine = isFirstOnLine;
    depth = (short) bracketDepth;
  }

  void setType(int type) {
    this.type = type;
  }

  void setTokenIndex(int index) {
    this.index = index;
  }

  /** Whether only blanks stand before it on its line. */
  boolean firstOnLine() {
    return firstOnLine;
  }

  /** How many brackets are open in front of it. */
  int depth() {
    return depth;
  }

  int startOffset() {
    return start;
  }

  /** The offset just past its last byte. */
  int endOffset() {
    return stop + 1;
  }

  SourceRange range() {
    return new SourceRange(start, Math.max(start, stop + 1));
  }

  boolean is(int wanted) {
    return type == wanted;
  }

  @Override
  public String getText() {
    return type == EOF ? "" : getInputStream().getText(Interval.of(start, stop));
  }

  @Override
  public int getType() {
    return type;
  }

  @Override
  public int getLine() {
    return line;
  }

  /** Not kept: columns come from the source when they are asked for. */
  @Override
  public int getCharPositionInLine() {
    return -1;
  }

  @Override
  public int getChannel() {
    return DEFAULT_CHANNEL;
  }

  @Override
  public int getTokenIndex() {
    return index;
  }

  @Override
  public int getStartIndex() {
    return start;
  }

  @Override
  public int getStopIndex() {
    return stop;
  }

  @Override
  public TokenSource getTokenSource() {
    return source;
  }

  @Override
  public CharStream getInputStream() {
    return source.getInputStream();
  }
}
