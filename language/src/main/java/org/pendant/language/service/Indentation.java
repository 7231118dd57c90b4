package org.pendant.language.service;

import java.util.ArrayDeque;
import java.util.Deque;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;

/**
 * Indentation: where each line begins: a step further in for each line that opened a block, two
 * steps for what continues a statement of the line before. The lexemes are passed in order.
 */
final class Indentation {
  private final Lexemes lexemes;
  private final int step;
  private final Deque<Open> open = new ArrayDeque<>();
  private int line;

  /**
   * A block or a bracket that is not closed yet.
   *
   * @param line the indentation of the line that opened it
   * @param insideHead whether the colon of the block's head is still to come
   */
  private record Open(boolean bracket, int line, boolean insideHead) {}

  Indentation(Lexemes lexemes, int step) {
    this.lexemes = lexemes;
    this.step = step;
  }

  /** Passes lexeme {@code index} and answers the indentation of its line. */
  int pass(int index) {
    Lexeme lexeme = lexemes.get(index);
    if (lexeme.firstOnLine()) {
      line = first(index, lexeme.kind());
    }
    boolean inBracket = !open.isEmpty() && open.peek().bracket();
    switch (lexeme.kind()) {
      case OPENER -> open.push(new Open(false, line, true));
      case OPEN -> open.push(new Open(true, line, false));
      case END -> open.poll();
      case CLOSE -> {
        if (inBracket) {
          open.pop();
        }
      }
      case ALTERNATIVE -> head(true);
      case COLON -> {
        if (!inBracket) {
          head(false);
        }
      }
      default -> {}
    }
    return line;
  }

  private void head(boolean inside) {
    if (!open.isEmpty()) {
      open.push(new Open(false, open.pop().line(), inside));
    }
  }

  private int first(int index, Kind kind) {
    boolean continued = continues(index, kind);
    if (open.isEmpty()) {
      return continued ? 2 * step : 0;
    }
    Open inner = open.peek();
    if (inner.bracket()) {
      return kind == Kind.CLOSE ? inner.line() : inner.line() + 2 * step;
    }
    if (kind == Kind.END || kind == Kind.ALTERNATIVE) {
      return inner.line();
    }
    if (inner.insideHead()) {
      return inner.line() + 2 * step;
    }
    return inner.line() + step + (continued ? 2 * step : 0);
  }

  private boolean continues(int index, Kind kind) {
    int previous = lexemes.previous(index);
    boolean unfinished =
        switch (lexemes.kind(previous)) {
          case OPERATOR, OPERATOR_WORD, ASSIGN, COMMA, DOT -> true;
          case STATEMENT_WORD ->
              switch (lexemes.text(previous)) {
                case "run", "join", "kill", "global", "local" -> true;
                default -> false;
              };
          default -> false;
        };
    boolean continues =
        switch (kind) {
          case OPERATOR, ASSIGN, COMMA, DOT -> true;
          case OPERATOR_WORD -> !lexemes.reads(index, "not");
          default -> false;
        };
    return unfinished || continues;
  }
}
