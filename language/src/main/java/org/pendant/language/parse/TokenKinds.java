package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

/** Token kinds: families of token types that more than one pass asks about. */
final class TokenKinds {
  private TokenKinds() {}

  static boolean isReservedWord(int type) {
    return type >= DEF && type <= NONE;
  }

  /** Words that belong to blocks and statements and can stand nowhere inside an expression. */
  static boolean beginsStatementForSure(int type) {
    return switch (type) {
      case DEF, SEC, THREAD, END, IF, ELIF, ELSE, WHILE, RETURN, BARE_RETURN, GLOBAL, LOCAL -> true;
      default -> false;
    };
  }

  /** Tokens a statement may begin with. */
  static boolean beginsStatement(int type) {
    return switch (type) {
      case NAME,
          RUN,
          GLOBAL,
          LOCAL,
          IF,
          WHILE,
          DEF,
          SEC,
          THREAD,
          RETURN,
          BARE_RETURN,
          BREAK,
          CONTINUE,
          HALT,
          PAUSE,
          JOIN,
          KILL,
          ENTER_CRITICAL,
          EXIT_CRITICAL,
          LABEL ->
          true;
      default -> false;
    };
  }

  /** Tokens that end a block or the part of a block. */
  static boolean endsBlock(int type) {
    return type == END || type == ELIF || type == ELSE;
  }

  static boolean opensBlock(int type) {
    return switch (type) {
      case DEF, SEC, THREAD, IF, WHILE -> true;
      default -> false;
    };
  }

  static boolean opensDefinition(int type) {
    return type == DEF || type == SEC || type == THREAD;
  }

  static boolean opensBracket(int type) {
    return switch (type) {
      case LPAREN, LBRACK, LINE_LPAREN, LINE_LBRACK -> true;
      default -> false;
    };
  }

  static boolean closesBracket(int type) {
    return type == RPAREN || type == RBRACK;
  }

  /** Tokens after which an expression may be complete. */
  static boolean endsOperand(int type) {
    return switch (type) {
      case NAME, INT, FLOAT, STRING, TRUE, FALSE, NONE, RPAREN, RBRACK, OPEN_STRING -> true;
      default -> false;
    };
  }

  /** Also what stands at the end of lines by mistake. */
  static boolean endsOperandOrLine(int type) {
    return switch (type) {
      case SEMICOLON, STRANGE, SINGLE_QUOTED, SLASH_COMMENT, COLON -> true;
      default -> endsOperand(type);
    };
  }

  /** Tokens that continue the line before when they stand first on theirs. */
  static boolean continuesLine(int type) {
    return switch (type) {
      case OR,
          XOR,
          AND,
          EQUAL,
          NOT_EQUAL,
          LESS,
          GREATER,
          LESS_OR_EQUAL,
          GREATER_OR_EQUAL,
          STAR,
          SLASH,
          PERCENT,
          DOT,
          COMMA,
          COLON,
          ASSIGN,
          RPAREN,
          RBRACK ->
          true;
      default -> false;
    };
  }

  static boolean isPrefix(int type) {
    return switch (type) {
      case NOT, BANG, MINUS, PLUS, LINE_MINUS, LINE_PLUS -> true;
      default -> false;
    };
  }
}
