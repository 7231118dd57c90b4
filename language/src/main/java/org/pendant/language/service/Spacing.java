package org.pendant.language.service;

import java.util.ArrayDeque;
import java.util.Deque;
import org.pendant.language.parse.Lexeme.Kind;

/** The blanks between two lexemes of one line. The lexemes are passed in order. */
final class Spacing {
  private static final String NONE = "";
  private static final String ONE = " ";
  private static final String BEFORE_COMMENT = "  ";

  private final Lexemes lexemes;
  private final Deque<Boolean> argumentsTight = new ArrayDeque<>();

  Spacing(Lexemes lexemes) {
    this.lexemes = lexemes;
  }

  /** Passes lexeme {@code index} and answers what should stand in place of {@code gap}. */
  String pass(int index, String gap) {
    String blanks = index == 0 ? NONE : between(index - 1, index, gap);
    Kind kind = lexemes.kind(index);
    if (kind == Kind.OPEN) {
      // Members are given values as variables are, arguments are not.
      argumentsTight.push(!lexemes.reads(index - 1, SymbolWalk.STRUCT));
    } else if (kind == Kind.CLOSE) {
      argumentsTight.poll();
    }
    return blanks;
  }

  private String between(int left, int right, String gap) {
    Kind before = lexemes.kind(left);
    Kind kind = lexemes.kind(right);
    if (kind == Kind.COMMENT) {
      // Comments of several lines often stand in one column.
      return gap.isEmpty() ? BEFORE_COMMENT : gap;
    }
    if (kind == Kind.DOT && before == Kind.NUMBER) {
      // Without the blank that the text has, the dot would belong to the number.
      return gap.isEmpty() ? NONE : ONE;
    }
    boolean tight =
        before == Kind.OPEN
            || before == Kind.DOT
            || isSign(left)
            || kind == Kind.COMMA
            || kind == Kind.CLOSE
            || kind == Kind.COLON
            || kind == Kind.DOT
            || (kind == Kind.OPEN && lexemes.get(left).endsOperand())
            || ((kind == Kind.ASSIGN || before == Kind.ASSIGN) && insideArguments());
    return tight ? NONE : ONE;
  }

  private boolean insideArguments() {
    return !argumentsTight.isEmpty() && argumentsTight.peek();
  }

  /** Whether this operator stands before its only operand. */
  private boolean isSign(int index) {
    if (!lexemes.is(index, Kind.OPERATOR)) {
      return false;
    }
    if (lexemes.reads(index, "!")) {
      return true;
    }
    int previous = lexemes.previous(index);
    boolean binary = previous >= 0 && lexemes.get(previous).endsOperand();
    return !binary && (lexemes.reads(index, "-") || lexemes.reads(index, "+"));
  }
}
