package org.pendant.language.parse;

import org.antlr.v4.runtime.Token;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.source.Source;

/**
 * Lexeme reader: cuts any text, right or wrong, into lexemes by the rules of the grammar. Unlike
 * the parser's tokens they include comments; between two of them stand only blanks and line ends.
 */
public final class LexemeReader {
  private final String text;
  private final LexemeTable.Builder lexemes;
  private int end;
  private boolean lineBegins = true;

  private LexemeReader(Source source, int start, int expected) {
    text = source.text();
    end = start;
    lexemes = new LexemeTable.Builder(16 + expected);
  }

  /**
   * For {@code source}, whose tokens another reads and hands on, from offset {@code start} on.
   *
   * @param expected so many lexemes, if that is known
   */
  static LexemeReader beside(Source source, int start, int expected) {
    return new LexemeReader(source, start, expected);
  }

  /** All lexemes of {@code source} in order. */
  public static LexemeTable lexemes(Source source) {
    ByteStream bytes = new ByteStream(source);
    LexemeReader reader = new LexemeReader(source, bytes.index(), source.text().length() / 4);
    UrScriptLexer lexer = new UrScriptLexer(bytes);
    lexer.setTokenFactory(ScriptToken.FACTORY);
    lexer.removeErrorListeners();
    while (!reader.take((ScriptToken) lexer.nextToken())) {
      // until the end of the text
    }
    return reader.taken();
  }

  /** Takes the next token as the lexer has made it; whether it is the end of the text. */
  boolean take(ScriptToken token) {
    boolean atEnd = token.is(Token.EOF);
    takeComments(atEnd ? text.length() : token.startOffset());
    if (!atEnd) {
      add(kind(token.getType()), token.startOffset(), token.endOffset());
    }
    return atEnd;
  }

  /** What was taken. */
  LexemeTable taken() {
    return lexemes.table();
  }

  /**
   * Takes the comments before offset {@code next}: the grammar skips blanks and comments alike, a
   * number sign tells them apart.
   */
  void takeComments(int next) {
    int at = end;
    while (at < next) {
      char found = text.charAt(at);
      if (found == '#') {
        int start = at;
        at = endOfComment(start, next);
        add(Kind.COMMENT, start, at);
      } else {
        lineBegins |= found == '\n';
        at++;
      }
    }
  }

  private int endOfComment(int start, int next) {
    int at = start;
    while (at < next && text.charAt(at) != '\n' && text.charAt(at) != '\r') {
      at++;
    }
    return at;
  }

  private void add(Kind kind, int start, int stop) {
    boolean member =
        !lineBegins && kind.compareTo(Kind.CONSTANT) <= 0 && lexemes.endsWith(Kind.DOT);
    lexemes.add(member ? Kind.NAME : kind, start, stop, lineBegins);
    lineBegins = false;
    end = stop;
  }

  private static Kind kind(int type) {
    return switch (type) {
      case UrScriptLexer.DEF,
          UrScriptLexer.SEC,
          UrScriptLexer.THREAD,
          UrScriptLexer.IF,
          UrScriptLexer.WHILE ->
          Kind.OPENER;
      case UrScriptLexer.ELIF, UrScriptLexer.ELSE -> Kind.ALTERNATIVE;
      case UrScriptLexer.END -> Kind.END;
      case UrScriptLexer.AND, UrScriptLexer.OR, UrScriptLexer.XOR, UrScriptLexer.NOT ->
          Kind.OPERATOR_WORD;
      case UrScriptLexer.TRUE, UrScriptLexer.FALSE, UrScriptLexer.NONE -> Kind.CONSTANT;
      case UrScriptLexer.NAME -> Kind.NAME;
      case UrScriptLexer.INT, UrScriptLexer.FLOAT -> Kind.NUMBER;
      case UrScriptLexer.STRING -> Kind.STRING;
      case UrScriptLexer.LABEL -> Kind.LABEL;
      case UrScriptLexer.LPAREN, UrScriptLexer.LBRACK -> Kind.OPEN;
      case UrScriptLexer.RPAREN, UrScriptLexer.RBRACK -> Kind.CLOSE;
      case UrScriptLexer.COMMA -> Kind.COMMA;
      case UrScriptLexer.COLON -> Kind.COLON;
      case UrScriptLexer.DOT -> Kind.DOT;
      case UrScriptLexer.ASSIGN -> Kind.ASSIGN;
      case UrScriptLexer.OPEN_STRING,
          UrScriptLexer.SINGLE_QUOTED,
          UrScriptLexer.SEMICOLON,
          UrScriptLexer.ARITHMETIC_ASSIGN,
          UrScriptLexer.COLON_ASSIGN,
          UrScriptLexer.DOUBLE_AMPERSAND,
          UrScriptLexer.DOUBLE_BAR,
          UrScriptLexer.ANGLES,
          UrScriptLexer.SLASH_COMMENT,
          UrScriptLexer.STRANGE ->
          Kind.FOREIGN;
      default -> TokenKinds.isReservedWord(type) ? Kind.STATEMENT_WORD : Kind.OPERATOR;
    };
  }
}
