package org.pendant.language.service;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;

/**
 * Call location: the bracket around an offset and where in it the offset stands, from the lexemes
 * alone: a call is seldom complete while its arguments are typed.
 *
 * @param opener the index of the opening bracket
 * @param position how many commas of this bracket stand before the offset
 * @param argument the index of the first lexeme of the argument at the offset; -1 when the argument
 *     is still empty
 */
record CallPlace(int opener, int position, int argument) {

  /** The innermost open bracket around {@code offset}. */
  static Optional<CallPlace> around(Lexemes lexemes, int offset) {
    return before(lexemes, lexemes.before(offset))
        .map(place -> place.isEmptyAt(lexemes, offset) ? place.withoutArgument() : place);
  }

  /** The next bracket further out. */
  Optional<CallPlace> outer(Lexemes lexemes) {
    return before(lexemes, opener - 1);
  }

  /** What stands on a later line is not what is typed here. */
  private boolean isEmptyAt(Lexemes lexemes, int offset) {
    if (argument >= lexemes.size()) {
      return true;
    }
    Lexeme first = lexemes.get(argument);
    return first.firstOnLine() && first.start() > offset;
  }

  private CallPlace withoutArgument() {
    return new CallPlace(opener, position, -1);
  }

  private static Optional<CallPlace> before(Lexemes lexemes, int last) {
    int depth = 0;
    int commas = 0;
    int argument = -1;
    for (int i = last; i >= 0; i--) {
      Lexeme lexeme = lexemes.get(i);
      switch (lexeme.kind()) {
        case CLOSE -> depth++;
        case OPEN -> {
          if (depth-- == 0) {
            return Optional.of(new CallPlace(i, commas, argument < 0 ? i + 1 : argument));
          }
        }
        case COMMA -> {
          if (depth == 0) {
            commas++;
            argument = argument < 0 ? i + 1 : argument;
          }
        }
        case OPENER, ALTERNATIVE, END, LABEL -> {
          return Optional.empty();
        }
        default -> {}
      }
      if (depth == 0 && beginsStatement(lexemes, i)) {
        return Optional.empty();
      }
    }
    return Optional.empty();
  }

  /** A line that begins with a name behind a complete value: the bracket before was forgotten. */
  private static boolean beginsStatement(Lexemes lexemes, int index) {
    Lexeme lexeme = lexemes.get(index);
    if (!lexeme.firstOnLine()) {
      return false;
    }
    int previous = lexemes.previous(index);
    return switch (lexeme.kind()) {
      case NAME -> previous < 0 || lexemes.get(previous).endsOperand();
      case STATEMENT_WORD -> !lexemes.reads(index, "run");
      default -> false;
    };
  }

  /** Whether this is the round bracket of a call or a {@code run}, not of a definition's head. */
  boolean isCall(Lexemes lexemes) {
    return lexemes.reads(opener, "(")
        && lexemes.is(opener - 1, Kind.NAME)
        && !lexemes.opensDefinition(opener - 2);
  }

  /** Whether this is the round bracket of a definition's head. */
  boolean isHead(Lexemes lexemes) {
    return lexemes.reads(opener, "(") && lexemes.opensDefinition(opener - 2);
  }

  /** Whether what is called is a method. */
  boolean isMethod(Lexemes lexemes) {
    return lexemes.is(opener - 2, Kind.DOT);
  }

  /** The name of the argument at the offset, if it is given by name. */
  Optional<String> argumentName(Lexemes lexemes) {
    return lexemes.is(argument, Kind.NAME) && lexemes.is(argument + 1, Kind.ASSIGN)
        ? Optional.of(lexemes.text(argument))
        : Optional.empty();
  }

  /** The names of all arguments of this call that are given by name. */
  Set<String> namesGiven(Lexemes lexemes) {
    Set<String> names = new HashSet<>();
    int depth = 0;
    int end = lexemes.close(opener);
    for (int i = opener; i < end; i++) {
      Kind kind = lexemes.kind(i);
      if (i > opener && depth == 1 && beginsStatement(lexemes, i)) {
        break;
      }
      depth += kind == Kind.OPEN ? 1 : kind == Kind.CLOSE ? -1 : 0;
      boolean begins = kind == Kind.OPEN || kind == Kind.COMMA;
      if (depth == 1 && begins && lexemes.is(i + 1, Kind.NAME) && lexemes.is(i + 2, Kind.ASSIGN)) {
        names.add(lexemes.text(i + 1));
      }
    }
    return names;
  }
}
