package org.pendant.language.parse;

import org.pendant.language.source.SourceRange;

/**
 * Lexeme: one word, sign, string, label or comment as it stands in the text.
 *
 * @param kind what it is, as far as it shows on its own
 * @param start offset of its first byte
 * @param end offset just past its last byte
 * @param firstOnLine whether only blanks stand before it on its line
 */
public record Lexeme(Kind kind, int start, int end, boolean firstOnLine) {

  /** Families of lexemes that editors tell apart. */
  public enum Kind {
    /** {@code def sec thread if while}. */
    OPENER,
    /** {@code elif else}. */
    ALTERNATIVE,
    END,
    /** Any other reserved word that begins a statement, and {@code run}. */
    STATEMENT_WORD,
    /** {@code and or xor not}. */
    OPERATOR_WORD,
    /** {@code True False None}. */
    CONSTANT,
    NAME,
    NUMBER,
    STRING,
    /** A line that begins with a dollar sign (manual 11). */
    LABEL,
    COMMENT,
    /** An opening round or square bracket. */
    OPEN,
    /** A closing round or square bracket. */
    CLOSE,
    COMMA,
    COLON,
    DOT,
    ASSIGN,
    OPERATOR,
    /** What has no place in a program: open strings, semicolons, signs of other languages. */
    FOREIGN
  }

  /** Where it stands. */
  public SourceRange range() {
    return new SourceRange(start, end);
  }

  /** Whether a word or a name stands here: something that a user types letter by letter. */
  public boolean isWord() {
    return kind.compareTo(Kind.NAME) <= 0;
  }

  /** Whether an expression may be complete behind it. */
  public boolean endsOperand() {
    return switch (kind) {
      case NAME, NUMBER, STRING, CONSTANT, CLOSE -> true;
      case OPENER,
          ALTERNATIVE,
          END,
          STATEMENT_WORD,
          OPERATOR_WORD,
          LABEL,
          COMMENT,
          OPEN,
          COMMA,
          COLON,
          DOT,
          ASSIGN,
          OPERATOR,
          FOREIGN ->
          false;
    };
  }
}
