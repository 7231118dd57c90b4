package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.Token;
import org.pendant.language.source.Source;

/**
 * Token pass: reads the tokens of a source and gives those where a line end matters their own type
 * (see the head of the grammar). It also measures how deeply the text nests, so that the recursive
 * passes after it never meet a text that would exhaust the stack.
 */
final class TokenPass {
  /** Brackets open at once; generated programs stay below ten. */
  static final int MAX_BRACKETS = 200;

  /** Blocks open at once. */
  static final int MAX_BLOCKS = 100;

  /** Prefix operators in a row. */
  static final int MAX_PREFIXES = 100;

  private final UrScriptLexer lexer;
  private final List<ScriptToken> tokens;
  private final Optional<LexemeReader> beside;
  private ScriptToken previous;
  private int brackets;
  private int blocks;
  private int prefixes;
  private Optional<TooDeep> tooDeep = Optional.empty();
  private Optional<TokenTable> table = Optional.empty();

  /** The token at which a limit was passed, and what there was too much of. */
  record TooDeep(ScriptToken token, String key, int limit) {}

  /**
   * Of a source.
   *
   * @param lexemes whether the lexemes are wanted as well
   */
  TokenPass(Source source, boolean lexemes) {
    ByteStream bytes = new ByteStream(source);
    int expected = 16 + source.text().length() / 4;
    beside =
        lexemes
            ? Optional.of(LexemeReader.beside(source, bytes.index(), expected))
            : Optional.empty();
    lexer = new UrScriptLexer(bytes);
    lexer.setTokenFactory(ScriptToken.FACTORY);
    lexer.removeErrorListeners();
    tokens = new ArrayList<>(expected);
  }

  /**
   * Goes on with a source whose tokens are known up to a line.
   *
   * @param before has these tokens
   * @param count how many they are
   * @param line the offset at which the line begins
   */
  TokenPass(Source source, TokenTable before, int count, int line) {
    ByteStream bytes = new ByteStream(source);
    if (line > 0) {
      bytes.seek(line);
    }
    beside = Optional.of(LexemeReader.beside(source, bytes.index(), 0));
    lexer = new UrScriptLexer(bytes);
    lexer.setTokenFactory(ScriptToken.FACTORY);
    lexer.removeErrorListeners();
    lexer.setLine(source.line(line));
    tokens = new ArrayList<>();
    previous = count == 0 ? null : before.token(count - 1, source, lexer);
    brackets = before.brackets(count);
    blocks = before.blocks(count);
    prefixes = before.prefixes(count);
  }

  UrScriptLexer lexer() {
    return lexer;
  }

  /** The lexemes of the whole text; empty where they were not wanted, or it was not read. */
  Optional<LexemeTable> lexemes() {
    return tooDeep.isPresent() ? Optional.empty() : beside.map(LexemeReader::taken);
  }

  Optional<TooDeep> tooDeep() {
    return tooDeep;
  }

  /** Every token up to and with end-of-file; fewer when the text nests too deeply. */
  List<ScriptToken> read() {
    while (tooDeep.isEmpty()) {
      ScriptToken token = (ScriptToken) lexer.nextToken();
      if (take(token)) {
        break;
      }
    }
    if (beside.isPresent() && tooDeep.isEmpty()) {
      table = Optional.of(TokenTable.of(tokens));
    }
    return tokens;
  }

  /** The tokens as they were read, whoever mends them later; empty where lexemes are. */
  Optional<TokenTable> table() {
    return table;
  }

  /**
   * Reads up to a token from which on everything is as it was in an earlier text.
   *
   * @param earlier the tokens of that
   * @param equalFrom the offset of a line from which on the texts are equal
   * @param shift how far offsets have moved there
   * @return the index of that token in {@code earlier}, its size if there is none
   */
  int readUntil(TokenTable earlier, int equalFrom, int shift) {
    while (tooDeep.isEmpty()) {
      ScriptToken token = (ScriptToken) lexer.nextToken();
      if (token.startOffset() >= equalFrom && isFirstOnLine(token)) {
        int known = earlier.indexAt(token.startOffset() - shift);
        if (continuesAt(earlier, known, token.startOffset() - shift)) {
          beside.orElseThrow().takeComments(token.startOffset());
          token.place(true, brackets);
          refineReturn(token);
          return known;
        }
      }
      if (take(token)) {
        break;
      }
    }
    return earlier.size();
  }

  /** Whether token {@code known} of an earlier text meets there what comes next here. */
  private boolean continuesAt(TokenTable earlier, int known, int offset) {
    return known < earlier.size()
        && earlier.start(known) == offset
        && earlier.brackets(known) == brackets
        && earlier.prefixes(known) == prefixes
        && (brackets == 0 || (known > 0 && previous.is(earlier.type(known - 1))));
  }

  private boolean isFirstOnLine(ScriptToken token) {
    return previous == null || previous.getLine() != token.getLine();
  }

  /** Takes the next token as the lexer has made it; whether it is the end of the text. */
  private boolean take(ScriptToken token) {
    if (beside.isPresent()) {
      var _ = beside.get().take(token);
    }
    boolean firstOnLine = isFirstOnLine(token);
    if (!firstOnLine && previous.is(DOT) && TokenKinds.isReservedWord(token.getType())) {
      token.setType(NAME);
    }
    if (firstOnLine && brackets > 0) {
      leaveUnclosedBrackets(token);
    }
    token.place(firstOnLine, brackets);
    if (token.is(LABEL)) {
      if (!firstOnLine) {
        token.setType(STRANGE);
      } else if (brackets > 0) {
        return false;
      }
    }
    refineReturn(token);
    refine(token);
    tokens.add(token);
    previous = token;
    return token.is(Token.EOF);
  }

  /** Those that were read. */
  List<ScriptToken> tokens() {
    return tokens;
  }

  /** A bracket that was forgotten must not hide the line ends of the rest of the file. */
  private void leaveUnclosedBrackets(ScriptToken token) {
    int type = token.getType();
    if (TokenKinds.beginsStatementForSure(type)
        || (type == NAME && TokenKinds.endsOperandOrLine(previous.getType()))) {
      brackets = 0;
    }
  }

  private void refineReturn(ScriptToken token) {
    if (previous != null
        && previous.is(RETURN)
        && (token.firstOnLine() || token.is(Token.EOF) || TokenKinds.endsBlock(token.getType()))) {
      previous.setType(BARE_RETURN);
    }
  }

  private void refine(ScriptToken token) {
    boolean lineStart = token.firstOnLine() && brackets == 0;
    int type = token.getType();
    switch (type) {
      case LPAREN, LBRACK -> {
        if (lineStart) {
          token.setType(type == LPAREN ? LINE_LPAREN : LINE_LBRACK);
        }
        brackets++;
        limit(token, brackets, "bracketsTooDeep", MAX_BRACKETS);
      }
      case RPAREN, RBRACK -> brackets = Math.max(0, brackets - 1);
      case PLUS, MINUS -> {
        if (lineStart) {
          token.setType(type == PLUS ? LINE_PLUS : LINE_MINUS);
        }
      }
      case DEF, SEC, THREAD, IF, WHILE -> {
        brackets = 0;
        blocks++;
        limit(token, blocks, "blocksTooDeep", MAX_BLOCKS);
      }
      case END -> {
        brackets = 0;
        blocks = Math.max(0, blocks - 1);
      }
      default -> {}
    }
    prefixes = TokenKinds.isPrefix(token.getType()) ? prefixes + 1 : 0;
    limit(token, prefixes, "prefixesTooDeep", MAX_PREFIXES);
  }

  private void limit(ScriptToken token, int count, String key, int limit) {
    if (count > limit) {
      tooDeep = Optional.of(new TooDeep(token, key, limit));
    }
  }
}
