package org.pendant.language.service;

import java.util.Optional;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.source.SourceRange;

/**
 * Completion location: where the caret stands, as far as it decides what may be typed there.
 *
 * @param role what may stand here
 * @param prefix what is typed of the word so far
 * @param word the word at the caret; empty between words
 * @param previous the index of the last lexeme before the word that is no comment, or -1
 * @param call the call whose argument begins here
 */
record CompletionPlace(
    Role role, String prefix, SourceRange word, int previous, Optional<CallPlace> call) {

  /** What may stand at the caret. */
  enum Role {
    NOTHING,
    STATEMENT,
    VALUE,
    /** Behind a complete value: only an operator continues. */
    OPERATOR,
    /** Behind a dot. */
    MEMBER,
    /** Behind {@code run}. */
    THREAD,
    /** Behind {@code global}. */
    GLOBAL
  }

  static CompletionPlace at(Lexemes lexemes, int offset) {
    int last = lexemes.before(offset);
    SourceRange word = new SourceRange(offset, offset);
    int previous = last;
    boolean nothing = false;
    if (last >= 0 && lexemes.get(last).end() >= offset) {
      Lexeme touched = lexemes.get(last);
      if (touched.isWord()) {
        word = touched.range();
        previous = last - 1;
      } else {
        nothing = isClosedTo(touched, offset);
      }
    }
    String prefix = lexemes.source().text().substring(word.start(), offset);
    boolean newLine = lineBegins(lexemes, word.start());
    while (previous >= 0 && lexemes.is(previous, Kind.COMMENT)) {
      previous--;
    }
    Optional<CallPlace> bracket = CallPlace.around(lexemes, word.start());
    boolean afterAssign = lexemes.is(previous, Kind.ASSIGN);
    nothing |= bracket.filter(place -> place.isHead(lexemes)).isPresent() && !afterAssign;
    Role role = nothing ? Role.NOTHING : role(lexemes, previous, newLine, bracket.isPresent());
    boolean argument = lexemes.is(previous, Kind.OPEN) || lexemes.is(previous, Kind.COMMA);
    return new CompletionPlace(
        role, prefix, word, previous, bracket.filter(place -> argument && place.isCall(lexemes)));
  }

  /** Whether nothing can be completed in or directly after this. */
  private static boolean isClosedTo(Lexeme lexeme, int offset) {
    return switch (lexeme.kind()) {
      case COMMENT, LABEL, NUMBER, FOREIGN -> true;
      case STRING -> lexeme.end() > offset;
      default -> false;
    };
  }

  private static boolean lineBegins(Lexemes lexemes, int offset) {
    String text = lexemes.source().text();
    int start = text.lastIndexOf('\n', offset - 1) + 1;
    return text.substring(start, offset).isBlank();
  }

  private static Role role(Lexemes lexemes, int previous, boolean newLine, boolean bracket) {
    if (previous < 0) {
      return Role.STATEMENT;
    }
    Lexeme before = lexemes.get(previous);
    return switch (before.kind()) {
      case DOT -> Role.MEMBER;
      case NAME, NUMBER, STRING, CONSTANT, CLOSE ->
          newLine && !bracket ? Role.STATEMENT : Role.OPERATOR;
      case COLON, END, ALTERNATIVE, LABEL -> statementOrCondition(lexemes, previous);
      case OPENER -> lexemes.opensDefinition(previous) ? Role.NOTHING : Role.VALUE;
      case STATEMENT_WORD -> behindWord(lexemes.text(previous), newLine);
      case OPERATOR_WORD, OPEN, COMMA, ASSIGN, OPERATOR, COMMENT, FOREIGN -> Role.VALUE;
    };
  }

  private static Role statementOrCondition(Lexemes lexemes, int previous) {
    return lexemes.reads(previous, "elif") ? Role.VALUE : Role.STATEMENT;
  }

  private static Role behindWord(String word, boolean newLine) {
    return switch (word) {
      case "run" -> Role.THREAD;
      case "global" -> Role.GLOBAL;
      case "local" -> Role.NOTHING;
      case "join", "kill" -> Role.VALUE;
      case "return" -> newLine ? Role.STATEMENT : Role.VALUE;
      default -> Role.STATEMENT;
    };
  }
}
