package org.pendant.language.parse;

import java.util.List;
import org.pendant.language.source.Source;

/** Indented lines: the tokens of a text by the columns of their lines. */
final class IndentedLines {
  private final Source source;
  private final List<ScriptToken> tokens;

  IndentedLines(Source source, List<ScriptToken> tokens) {
    this.source = source;
    this.tokens = tokens;
  }

  /** The column from 1 of a token that is first on its line; 0 of any other. */
  int column(ScriptToken token) {
    return token.firstOnLine() ? source.column(token.startOffset()) : 0;
  }

  /** Whether {@code opener} is first on its line and the next line is further in. */
  boolean indents(ScriptToken opener) {
    return opener.firstOnLine() && column(nextLine(index(opener) + 1)) > column(opener);
  }

  /**
   * The token in front of which a block lacks its {@code end}.
   *
   * @param opener the first word of the block
   * @param from a word of the block, after which it is missing
   * @param to the next word that cannot be part of it
   * @return the first line between the two that stands no further in than the block; {@code to} if
   *     none does or the block is not indented
   */
  ScriptToken outside(ScriptToken opener, ScriptToken from, ScriptToken to) {
    int column = column(opener);
    if (column == 0 || !indents(opener)) {
      return to;
    }
    for (int at = index(from) + 1; tokens.get(at) != to; at++) {
      ScriptToken token = tokens.get(at);
      if (token.firstOnLine()
          && token.depth() == 0
          && column(token) <= column
          && !TokenKinds.continuesLine(token.getType())) {
        return token;
      }
    }
    return to;
  }

  private ScriptToken nextLine(int from) {
    int at = Math.min(from, tokens.size() - 1);
    while (at < tokens.size() - 1 && !tokens.get(at).firstOnLine()) {
      at++;
    }
    return tokens.get(at);
  }

  /** Where {@code word} is; tokens are in the order of the text. */
  private int index(ScriptToken word) {
    int low = 0;
    int high = tokens.size() - 1;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (tokens.get(middle).startOffset() < word.startOffset()) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    while (tokens.get(low) != word) {
      low++;
    }
    return low;
  }
}
