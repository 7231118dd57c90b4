package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.antlr.v4.runtime.TokenSource;
import org.pendant.language.source.Source;

/**
 * Token table: all tokens of one text as the token pass leaves them, ended by end-of-file. It is
 * what is kept of a text that may be read again after a small change; it never changes itself.
 */
final class TokenTable {
  private final byte[] types;
  private final int[] starts;
  private final int[] ends;

  /** Twice the depth, and one more for a token that is first on its line. */
  private final short[] places;

  private TokenTable(byte[] types, int[] starts, int[] ends, short[] places) {
    this.types = types;
    this.starts = starts;
    this.ends = ends;
    this.places = places;
  }

  static TokenTable of(List<ScriptToken> tokens) {
    int size = tokens.size();
    TokenTable table =
        new TokenTable(new byte[size], new int[size], new int[size], new short[size]);
    for (int i = 0; i < size; i++) {
      ScriptToken token = tokens.get(i);
      table.types[i] = (byte) token.getType();
      table.starts[i] = token.startOffset();
      table.ends[i] = token.endOffset();
      table.places[i] = (short) (token.depth() * 2 + (token.firstOnLine() ? 1 : 0));
    }
    return table;
  }

  /**
   * This table with other tokens in the place of some.
   *
   * @param from the index of the first that is replaced
   * @param to the index after the last that is replaced
   * @param shift how far those behind have moved
   */
  TokenTable with(int from, int to, List<ScriptToken> others, int shift) {
    TokenTable inserted = of(others);
    return new TokenTable(
        Splice.of(types, from, to, inserted.types),
        Splice.moved(starts, from, to, inserted.starts, shift),
        Splice.moved(ends, from, to, inserted.ends, shift),
        Splice.of(places, from, to, inserted.places));
  }

  int size() {
    return types.length;
  }

  int type(int index) {
    return types[index];
  }

  int start(int index) {
    return starts[index];
  }

  /** Where the text ends. */
  int end() {
    return starts[starts.length - 1];
  }

  /** The index of the first token that does not begin before {@code offset}; the size if all do. */
  int indexAt(int offset) {
    int found = Arrays.binarySearch(starts, offset);
    return found >= 0 ? found : -found - 1;
  }

  /** Token {@code index} as an object of its own. */
  ScriptToken token(int index, Source source, TokenSource maker) {
    return token(index, source.line(starts[index]), maker);
  }

  private ScriptToken token(int index, int line, TokenSource maker) {
    ScriptToken token = new ScriptToken(maker, types[index], starts[index], ends[index] - 1, line);
    token.place((places[index] & 1) != 0, places[index] >> 1);
    token.setTokenIndex(index);
    return token;
  }

  /** All of them as objects. */
  List<ScriptToken> tokens(Source source, TokenSource maker) {
    List<ScriptToken> tokens = new ArrayList<>(size());
    int line = 1;
    for (int i = 0; i < size(); i++) {
      while (line < source.lineCount() && source.lineStart(line + 1) <= starts[i]) {
        line++;
      }
      tokens.add(token(i, line, maker));
    }
    return tokens;
  }

  /** How many brackets are open behind the first {@code count} tokens. */
  int brackets(int count) {
    if (count == 0) {
      return 0;
    }
    int depth = places[count - 1] >> 1;
    int type = types[count - 1];
    if (TokenKinds.opensBracket(type)) {
      return depth + 1;
    }
    if (TokenKinds.closesBracket(type)) {
      return Math.max(0, depth - 1);
    }
    return TokenKinds.opensBlock(type) || type == END ? 0 : depth;
  }

  /** How many prefix operators in a row end the first {@code count} tokens. */
  int prefixes(int count) {
    int first = count;
    while (first > 0 && TokenKinds.isPrefix(types[first - 1])) {
      first--;
    }
    return count - first;
  }

  /** How many blocks are open behind the first {@code count} tokens. */
  int blocks(int count) {
    int blocks = 0;
    for (int i = 0; i < count; i++) {
      blocks = blocksBehind(types[i], blocks);
    }
    return blocks;
  }

  /** The most blocks that are open at once. */
  int deepest() {
    int blocks = 0;
    int deepest = 0;
    for (byte type : types) {
      blocks = blocksBehind(type, blocks);
      deepest = Math.max(deepest, blocks);
    }
    return deepest;
  }

  private static int blocksBehind(int type, int blocks) {
    return TokenKinds.opensBlock(type)
        ? blocks + 1
        : type == END ? Math.max(0, blocks - 1) : blocks;
  }
}
